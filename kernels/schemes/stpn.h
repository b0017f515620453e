// Scalar tagged PN triangles (after Boubekeur, Reuter, Schlick: Scalar Tagged PN Triangles, Eurographics short papers,
// 2005): PN triangles whose vertices carry sharpness, bias and tension, and whose edges may be creases. The names and
// roles of the tags are the paper's; the formulas below are this project's, chosen so that the surface stays a cubic
// Bezier triangle and is that of PN triangles where all tags are zero.
#ifndef TESSERA_SCHEMES_STPN_H
#define TESSERA_SCHEMES_STPN_H

#include "schemes/pn.h"
#include "schemes/tags.h"

KERNELS_BEGIN

/// The Bezier point of the edge from a to b that lies next to a. With d = P_b - P_a:
///   smooth  d - (1 - sharpness) (1 + bias) (d . N) N         PN's tangent; sharpness 1 or bias -1 lead straight to b
///   crease  sharpness d + (1 - sharpness) (d . C) C          along the crease through a; d where there is none
///   point   P_a + (1 - tension) / 3 ((1 - s) smooth + s crease), s the sharpness of the edge
/// N is the corner's normal on a smooth edge, else the vertex's, which both patches share. So the point depends on
/// what the two patches of the edge share only, and is the same for both.
FUNCTION Vector stpn_edge_point(Vector pa, CornerTags corner, VertexTags a, Vector pb, float s) {
    const Vector d = subtract(pb, pa);
    const bool creased = s > 0.0f;
    const Vector n = make_vector(creased ? a.normal.x : corner.normal.x, creased ? a.normal.y : corner.normal.y,
                                 creased ? a.normal.z : corner.normal.z);
    const float bulge = (1.0f - a.sharpness) * (1.0f + a.bias);
    const Vector smooth_tangent = flush_vector(subtract(d, scale(n, dot_product(d, n) * bulge)));
    const Vector along = flush_vector(scale(a.crease, dot_product(d, a.crease)));
    const bool passes = dot_product(a.crease, a.crease) > 0.0f;
    const Vector curved = make_vector(passes ? along.x : d.x, passes ? along.y : d.y, passes ? along.z : d.z);
    const Vector crease_tangent = add(scale(d, a.sharpness), scale(curved, 1.0f - a.sharpness));
    const Vector tangent = add(scale(smooth_tangent, 1.0f - s), scale(crease_tangent, s));
    return add(pa, scale(tangent, ONE_THIRD * (1.0f - a.tension)));
}

FUNCTION PnNet stpn_net(Corners corners, CornerTags k0, CornerTags k1, CornerTags k2, VertexTags t0, VertexTags t1,
                        VertexTags t2) {
    PnNet net;
    net.c0 = corners.p0;
    net.c1 = corners.p1;
    net.c2 = corners.p2;
    net.c01 = stpn_edge_point(corners.p0, k0, t0, corners.p1, k0.edge);
    net.c10 = stpn_edge_point(corners.p1, k1, t1, corners.p0, k0.edge);
    net.c12 = stpn_edge_point(corners.p1, k1, t1, corners.p2, k1.edge);
    net.c21 = stpn_edge_point(corners.p2, k2, t2, corners.p1, k1.edge);
    net.c20 = stpn_edge_point(corners.p2, k2, t2, corners.p0, k2.edge);
    net.c02 = stpn_edge_point(corners.p0, k0, t0, corners.p2, k2.edge);
    net.centre = pn_centre(net);
    return net;
}

KERNELS_END

#endif
