// The isoline domain: lines of constant v, listed one after another with their points in order of u. There is no line
// at v = 1. Factors: density (how many lines, always an integer), detail (segments per line).
#ifndef TESSERA_TESSELLATOR_ISOLINE_H
#define TESSERA_TESSELLATOR_ISOLINE_H

#include "tessellator/edge.h"

KERNELS_BEGIN

STRUCT(IsolinePatch) {
    uint flags;
    Edge density;
    Edge detail;
};

/// Reads a patch record from a buffer.
#define LOAD_ISOLINE_PATCH(records, patch_index)                                                      \
    make_isoline_patch(records[(patch_index)*RECORD_WORDS], records[(patch_index)*RECORD_WORDS + 1u], \
                       records[(patch_index)*RECORD_WORDS + 2u])

FUNCTION IsolinePatch make_isoline_patch(uint flags, uint density, uint detail) {
    IsolinePatch p;
    const uint odd = flags >> RECORD_ODD_SHIFT;
    p.flags = flags;
    p.density = make_edge(density, odd & 1u);
    p.detail = make_edge(detail, (odd >> 1u) & 1u);
    return p;
}

FUNCTION uint isoline_point_count(IsolinePatch p) {
    return (p.flags & RECORD_CULLED) != 0u ? 0u : (p.density.points - 1u) * p.detail.points;
}

FUNCTION uint isoline_segment_count(IsolinePatch p) {
    return (p.flags & RECORD_CULLED) != 0u ? 0u : (p.density.points - 1u) * (p.detail.points - 1u);
}

FUNCTION DomainPoint isoline_point(IsolinePatch p, uint i) {
    return make_domain_point(edge_coordinate(p.detail, i % p.detail.points),
                             edge_coordinate(p.density, i / p.detail.points));
}

/// First point of segment s; the second follows it.
FUNCTION uint isoline_segment(IsolinePatch p, uint s) {
    const uint segments = p.detail.points - 1u;
    return (s / segments) * p.detail.points + s % segments;
}

KERNELS_END

#endif
