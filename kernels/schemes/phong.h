// Phong tessellation (Boubekeur and Alexa 2008) as a quadratic Bezier triangle.
//
// The paper projects the flat point p(u,v) onto the tangent plane of each corner and blends the projections
// barycentrically:
//   p* = (1 - alpha) p + alpha (u pi_0(p) + v pi_1(p) + w pi_2(p)).
// Here every corner has an alpha of its own, which blends its projection: p* = u q_0(p) + v q_1(p) + w q_2(p) with
// q_i(p) = (1 - alpha_i) p + alpha_i pi_i(p); with equal alphas it is the same. q_i is affine and q_i(p_i) = p_i, so p*
// is quadratic with the corners as Bezier points and, between corners i and j, c_ij = (q_i(p_j) + q_j(p_i)) / 2.
#ifndef TESSERA_SCHEMES_PHONG_H
#define TESSERA_SCHEMES_PHONG_H

#include "schemes/tags.h"

KERNELS_BEGIN

STRUCT(PhongNet) {
    Vector c0;
    Vector c1;
    Vector c2;
    Vector c01;
    Vector c12;
    Vector c20;
};

/// q taken the share alpha of the way to the plane through p with unit normal n.
FUNCTION Vector pull_to_plane(Vector q, Vector p, Vector n, float alpha) {
    return flush_vector(subtract(q, scale(n, dot_product(subtract(q, p), n) * alpha)));
}

/// The Bezier point between two corners; the same bits from either side.
FUNCTION Vector phong_edge_point(Vector pa, Vector na, float alpha_a, Vector pb, Vector nb, float alpha_b) {
    return scale(add(pull_to_plane(pb, pa, na, alpha_a), pull_to_plane(pa, pb, nb, alpha_b)), 0.5f);
}

FUNCTION PhongNet phong_net(Corners corners, float alpha0, float alpha1, float alpha2) {
    PhongNet net;
    net.c0 = corners.p0;
    net.c1 = corners.p1;
    net.c2 = corners.p2;
    net.c01 = phong_edge_point(corners.p0, corners.n0, alpha0, corners.p1, corners.n1, alpha1);
    net.c12 = phong_edge_point(corners.p1, corners.n1, alpha1, corners.p2, corners.n2, alpha2);
    net.c20 = phong_edge_point(corners.p2, corners.n2, alpha2, corners.p0, corners.n0, alpha0);
    return net;
}

KERNELS_END

#endif
