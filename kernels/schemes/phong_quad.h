// Phong tessellation of quads (Dupuy, Phong Tessellation for Quads, eq. 1-3) as a biquadratic Bezier patch.
//
// With q the bilinear point and B_i the bilinear weights, P = sum_i B_i pi_i(q) = sum_ij B_i B_j pi_i(p_j):
// biquadratic, with the corners and the edge points of triangles, and in the middle the mean of pi_0(p_2), pi_2(p_0),
// pi_1(p_3), pi_3(p_1). Each corner's alpha blends its pi_i(p_j) with p_j, as for triangles.
#ifndef TESSERA_SCHEMES_PHONG_QUAD_H
#define TESSERA_SCHEMES_PHONG_QUAD_H

#include "schemes/phong.h"
#include "schemes/quad_corners.h"

KERNELS_BEGIN

STRUCT(PhongQuadNet) {
    Vector c0;
    Vector c1;
    Vector c2;
    Vector c3;
    Vector c01;
    Vector c12;
    Vector c23;
    Vector c30;
    Vector centre;
};

FUNCTION PhongQuadNet phong_quad_net(QuadCorners corners, float alpha0, float alpha1, float alpha2, float alpha3) {
    PhongQuadNet net;
    net.c0 = corners.p0;
    net.c1 = corners.p1;
    net.c2 = corners.p2;
    net.c3 = corners.p3;
    net.c01 = phong_edge_point(corners.p0, corners.n0, alpha0, corners.p1, corners.n1, alpha1);
    net.c12 = phong_edge_point(corners.p1, corners.n1, alpha1, corners.p2, corners.n2, alpha2);
    net.c23 = phong_edge_point(corners.p2, corners.n2, alpha2, corners.p3, corners.n3, alpha3);
    net.c30 = phong_edge_point(corners.p3, corners.n3, alpha3, corners.p0, corners.n0, alpha0);
    const Vector diagonal02 = phong_edge_point(corners.p0, corners.n0, alpha0, corners.p2, corners.n2, alpha2);
    const Vector diagonal13 = phong_edge_point(corners.p1, corners.n1, alpha1, corners.p3, corners.n3, alpha3);
    net.centre = scale(add(diagonal02, diagonal13), 0.5f);
    return net;
}

KERNELS_END

#endif
