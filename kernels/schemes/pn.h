// PN triangles (Vlachos, Peters, Boyd, Mitchell: Curved PN Triangles, 2001): a cubic Bezier triangle from the positions
// and normals of the three corners.
#ifndef TESSERA_SCHEMES_PN_H
#define TESSERA_SCHEMES_PN_H

#include "schemes/corners.h"

KERNELS_BEGIN

STRUCT(PnNet) {
    Vector c0;
    Vector c1;
    Vector c2;
    Vector c01;
    Vector c10;
    Vector c12;
    Vector c21;
    Vector c20;
    Vector c02;
    Vector centre;
};

#define ONE_THIRD 0.333333343f
#define ONE_SIXTH 0.166666672f

/// The Bezier point a third of the way from corner a to corner b, projected onto the tangent plane at a:
/// (2 P_a + P_b - ((P_b - P_a) . N_a) N_a) / 3 (Vlachos et al. 2001, section 3.2). It depends on its edge only and
/// is the same whichever patch asks.
FUNCTION Vector pn_edge_point(Vector pa, Vector na, Vector pb) {
    const Vector d = subtract(pb, pa);
    const Vector tangent = subtract(d, scale(na, dot_product(d, na)));
    return add(pa, scale(tangent, ONE_THIRD));
}

/// b_111 = E + (E - V) / 2, E the mean of the six edge points, V that of the corners.
FUNCTION Vector pn_centre(PnNet net) {
    const Vector edges = add(add(add(net.c01, net.c10), add(net.c12, net.c21)), add(net.c20, net.c02));
    const Vector e = scale(edges, ONE_SIXTH);
    const Vector v = scale(add(add(net.c0, net.c1), net.c2), ONE_THIRD);
    return add(e, scale(subtract(e, v), 0.5f));
}

FUNCTION PnNet pn_net(Corners corners) {
    PnNet net;
    net.c0 = corners.p0;
    net.c1 = corners.p1;
    net.c2 = corners.p2;
    net.c01 = pn_edge_point(corners.p0, corners.n0, corners.p1);
    net.c10 = pn_edge_point(corners.p1, corners.n1, corners.p0);
    net.c12 = pn_edge_point(corners.p1, corners.n1, corners.p2);
    net.c21 = pn_edge_point(corners.p2, corners.n2, corners.p1);
    net.c20 = pn_edge_point(corners.p2, corners.n2, corners.p0);
    net.c02 = pn_edge_point(corners.p0, corners.n0, corners.p2);
    net.centre = pn_centre(net);
    return net;
}

KERNELS_END

#endif
