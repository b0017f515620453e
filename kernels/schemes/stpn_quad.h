// Scalar tagged PN quads: the boundary curves of stpn.h, the interior points of PN quads. A quad whose edges are all
// sharp and straight is bilinear.
#ifndef TESSERA_SCHEMES_STPN_QUAD_H
#define TESSERA_SCHEMES_STPN_QUAD_H

#include "schemes/pn_quad.h"
#include "schemes/stpn.h"

KERNELS_BEGIN

FUNCTION PnQuadNet stpn_quad_net(QuadCorners corners, CornerTags k0, CornerTags k1, CornerTags k2, CornerTags k3,
                                 VertexTags t0, VertexTags t1, VertexTags t2, VertexTags t3) {
    PnQuadNet net;
    net.c0 = corners.p0;
    net.c1 = corners.p1;
    net.c2 = corners.p2;
    net.c3 = corners.p3;
    net.c01 = stpn_edge_point(corners.p0, k0, t0, corners.p1, k0.edge);
    net.c10 = stpn_edge_point(corners.p1, k1, t1, corners.p0, k0.edge);
    net.c12 = stpn_edge_point(corners.p1, k1, t1, corners.p2, k1.edge);
    net.c21 = stpn_edge_point(corners.p2, k2, t2, corners.p1, k1.edge);
    net.c23 = stpn_edge_point(corners.p2, k2, t2, corners.p3, k2.edge);
    net.c32 = stpn_edge_point(corners.p3, k3, t3, corners.p2, k2.edge);
    net.c30 = stpn_edge_point(corners.p3, k3, t3, corners.p0, k3.edge);
    net.c03 = stpn_edge_point(corners.p0, k0, t0, corners.p3, k3.edge);
    return with_coons_interior(net);
}

KERNELS_END

#endif
