// The triangle domain walked from its first point to its last triangle, ring side after ring side: what a serial
// tessellator does. The stages find any element by its index instead (triangle.h); this is for the peer that they are
// measured against.
#ifndef TESSERA_TESSELLATOR_SERIAL_TRIANGLE_H
#define TESSERA_TESSELLATOR_SERIAL_TRIANGLE_H

#include "tessellator/triangle.h"

KERNELS_BEGIN

/// The points of one side of one ring, the last one left to the next side. Ring 0 is the outer one.
STRUCT(RingSide) {
    Edge edge;           // places points along the side
    uint number;         // 0..2
    uint first;          // index of its first point
    uint segments;       // points on it
    uint from;           // position of its first point on the edge; side 1 runs up from there, the others down
    uint perpendicular;  // the coordinate that stays; 0 on the outer ring
};

FUNCTION RingSide triangle_ring_side(TrianglePatch p, uint r, uint number) {
    RingSide side;
    side.number = number;
    if (r == 0u) {
        const uint start1 = p.edge0.points - 1u;
        side.edge = choose_edge(number == 2u, choose_edge(number == 1u, p.edge0, p.edge1), p.edge2);
        side.segments = side.edge.points - 1u;
        side.first = number == 0u ? 0u : (number == 1u ? start1 : start1 + p.edge1.points - 1u);
        side.from = number == 1u ? 0u : side.segments;
        side.perpendicular = 0u;
        return side;
    }
    const uint n = p.inside.points;
    side.edge = p.inside;
    side.segments = n - 1u - 2u * r;
    side.first = p.outer_points + ring_start(r, n) + number * side.segments;
    side.from = number == 1u ? r : n - 1u - r;
    side.perpendicular = (edge_coordinate(p.inside, r) * 0xaaaau + 0x8000u) >> 16u;
    return side;
}

FUNCTION DomainPoint ring_side_point(RingSide side, uint k) {
    const uint q = side.number == 1u ? side.from + k : side.from - k;
    const uint across = side.perpendicular;
    const uint along = edge_coordinate(side.edge, q) - ((across + 1u) >> 1u);
    return make_domain_point(side.number == 0u ? across : along,
                             side.number == 0u ? along : (side.number == 1u ? across : 65536u - along - across));
}

FUNCTION DomainPoint triangle_centre() {
    return make_domain_point(0x5555u, 0x5555u);
}

/// The triangles of one side of a row. Row j lies between rings j - 1 and j of points; row 1, at the outer ring, joins
/// two factors, the others are regular.
STRUCT(RowSide) {
    Ring outer;
    Ring inner;
    uint outer_offset;  // where the side begins on the outer ring
    uint inner_offset;
    uint first;      // index of its first triangle
    uint triangles;  // on it
    uint points;     // of the inner ring on this side, both corners included
};

/// Side `number` of row j >= 2.
FUNCTION RowSide triangle_row_side(TrianglePatch p, uint j, uint number) {
    const uint n = p.inside.points;
    RowSide side;
    side.points = n - 2u * j;
    side.triangles = 2u * side.points;
    // Row j begins after 6 ((j - 2) N - (j - 1) j + 2) triangles of inner rows.
    const uint before = 6u * ((j - 2u) * n + 2u - (j - 1u) * j);
    side.first = p.outer_points + 3u * (n - 3u) + before + number * side.triangles;
    const uint outer_segments = side.points + 1u;
    const uint outer_start = p.outer_points + ring_start(j - 1u, n);
    side.outer = make_ring(outer_start, 3u * outer_segments);
    side.inner = make_ring(outer_start + 3u * outer_segments, 3u * (side.points - 1u));
    side.outer_offset = number * outer_segments;
    side.inner_offset = number * (side.points - 1u);
    return side;
}

FUNCTION Triangle row_side_triangle(RowSide side, uint s) {
    return place_row(ring_triangle(s, side.points), side.outer, side.outer_offset, side.inner, side.inner_offset);
}

/// The innermost row of triangles; the rows are 1..this.
FUNCTION uint triangle_last_row(TrianglePatch p) {
    return (p.inside.points - 1u) >> 1u;
}

/// The one triangle over the last ring, last of all, where the inside factor is odd.
FUNCTION Triangle triangle_odd_centre(TrianglePatch p) {
    const uint b = p.outer_points + ring_start(p.rings, p.inside.points);
    return make_triangle(b, b + 1u, b + 2u);
}

KERNELS_END

#endif
