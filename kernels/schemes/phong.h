// Phong tessellation (Boubekeur and Alexa 2008) as a quadratic Bezier triangle.
//
// The paper projects the flat point p(u,v) onto the tangent plane of each corner and blends the projections
// barycentrically:
//   p* = (1 - alpha) p + alpha (u pi_0(p) + v pi_1(p) + w pi_2(p)).
// pi_i is affine and pi_i(p_i) = p_i, so p* is quadratic with the corners as Bezier points and, between corners i and
// j,
//   c_ij = (1 - alpha) (p_i + p_j) / 2 + alpha (pi_i(p_j) + pi_j(p_i)) / 2.
#ifndef TESSERA_SCHEMES_PHONG_H
#define TESSERA_SCHEMES_PHONG_H

#include "schemes/corners.h"

KERNELS_BEGIN

STRUCT(PhongNet) {
    Vector c0;
    Vector c1;
    Vector c2;
    Vector c01;
    Vector c12;
    Vector c20;
};

/// q projected onto the plane through p with unit normal n.
FUNCTION Vector project_to_plane(Vector q, Vector p, Vector n) {
    return subtract(q, scale(n, dot_product(subtract(q, p), n)));
}

/// The Bezier point between two corners; the same bits from either side.
FUNCTION Vector phong_edge_point(Vector pa, Vector na, Vector pb, Vector nb, float alpha) {
    const Vector flat_sum = add(pa, pb);
    const Vector curved_sum = add(project_to_plane(pb, pa, na), project_to_plane(pa, pb, nb));
    return scale(add(scale(flat_sum, 1.0f - alpha), scale(curved_sum, alpha)), 0.5f);
}

FUNCTION PhongNet phong_net(Corners corners, float alpha) {
    PhongNet net;
    net.c0 = corners.p0;
    net.c1 = corners.p1;
    net.c2 = corners.p2;
    net.c01 = phong_edge_point(corners.p0, corners.n0, corners.p1, corners.n1, alpha);
    net.c12 = phong_edge_point(corners.p1, corners.n1, corners.p2, corners.n2, alpha);
    net.c20 = phong_edge_point(corners.p2, corners.n2, corners.p0, corners.n0, alpha);
    return net;
}

KERNELS_END

#endif
