// PN quads: a bicubic Bezier patch whose boundary curves are those of PN triangles (Peters, PN-quads, 2008: the same
// rules, only the interior points differ).
//
// The four interior points are those of the bilinearly blended Coons patch of the boundary, which keeps bilinear quads
// and any sum of a curve in u and a curve in v as they are.
#ifndef TESSERA_SCHEMES_PN_QUAD_H
#define TESSERA_SCHEMES_PN_QUAD_H

#include "schemes/pn.h"
#include "schemes/quad_corners.h"

KERNELS_BEGIN

STRUCT(PnQuadNet) {
    Vector c0;
    Vector c1;
    Vector c2;
    Vector c3;
    Vector c01;
    Vector c10;
    Vector c12;
    Vector c21;
    Vector c23;
    Vector c32;
    Vector c30;
    Vector c03;
    Vector inner0;
    Vector inner1;
    Vector inner2;
    Vector inner3;
};

#define ONE_NINTH 0.111111112f

/// The interior point next to corner a, whose neighbours are b and d and whose opposite is c:
/// (6 (c_ab + c_ad) + 3 (c_bc + c_dc) - 4 P_a - 2 (P_b + P_d) - P_c) / 9.
FUNCTION Vector coons_point(Vector pa, Vector pb, Vector pc, Vector pd, Vector cab, Vector cad, Vector cbc,
                            Vector cdc) {
    const Vector near_edges = scale(add(cab, cad), 6.0f);
    const Vector far_edges = scale(add(cbc, cdc), 3.0f);
    const Vector corners = add(add(scale(pa, 4.0f), scale(add(pb, pd), 2.0f)), pc);
    return scale(subtract(add(near_edges, far_edges), corners), ONE_NINTH);
}

/// The net with the interior points that its boundary asks for.
FUNCTION PnQuadNet with_coons_interior(PnQuadNet boundary) {
    PnQuadNet net = boundary;
    net.inner0 = coons_point(net.c0, net.c1, net.c2, net.c3, net.c01, net.c03, net.c12, net.c32);
    net.inner1 = coons_point(net.c1, net.c2, net.c3, net.c0, net.c12, net.c10, net.c23, net.c03);
    net.inner2 = coons_point(net.c2, net.c3, net.c0, net.c1, net.c23, net.c21, net.c30, net.c10);
    net.inner3 = coons_point(net.c3, net.c0, net.c1, net.c2, net.c30, net.c32, net.c01, net.c21);
    return net;
}

FUNCTION PnQuadNet pn_quad_net(QuadCorners corners) {
    PnQuadNet net;
    net.c0 = corners.p0;
    net.c1 = corners.p1;
    net.c2 = corners.p2;
    net.c3 = corners.p3;
    net.c01 = pn_edge_point(corners.p0, corners.n0, corners.p1);
    net.c10 = pn_edge_point(corners.p1, corners.n1, corners.p0);
    net.c12 = pn_edge_point(corners.p1, corners.n1, corners.p2);
    net.c21 = pn_edge_point(corners.p2, corners.n2, corners.p1);
    net.c23 = pn_edge_point(corners.p2, corners.n2, corners.p3);
    net.c32 = pn_edge_point(corners.p3, corners.n3, corners.p2);
    net.c30 = pn_edge_point(corners.p3, corners.n3, corners.p0);
    net.c03 = pn_edge_point(corners.p0, corners.n0, corners.p3);
    return with_coons_interior(net);
}

KERNELS_END

#endif
