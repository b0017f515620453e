// The triangle domain: points and triangles of a patch by their index, in the order of the D3D11 tessellator. Every
// element is computed on its own, so that any item may make any of them.
//
//          V = 65536                 Edge U=0 is opposite to control point 0, V=0 to 1, W=0 to 2. Points: the outer
//            |\                      ring (edges U=0, V=0, W=0, each without its last point), then ring after ring
//      U=0   | \   W=0               inwards, then the centre where the inside factor is even.
//            |__\                    .
//  (0,0)      V=0   U = 65536
#ifndef TESSERA_TESSELLATOR_TRIANGLE_H
#define TESSERA_TESSELLATOR_TRIANGLE_H

#include "tessellator/row.h"

KERNELS_BEGIN

/// What the record of a triangle patch says, unpacked once per patch.
STRUCT(TrianglePatch) {
    uint flags;
    uint level;  // of a uniform pattern
    Edge edge0;
    Edge edge1;
    Edge edge2;
    Edge inside;
    uint outer_points;  // points of the outer ring
    uint rings;         // inner rings of points, without the centre
};

/// Reads a patch record from a buffer.
#define LOAD_TRIANGLE_PATCH(records, patch_index)                                                           \
    make_triangle_patch(records[(patch_index)*RECORD_WORDS], records[(patch_index)*RECORD_WORDS + 1u],      \
                        records[(patch_index)*RECORD_WORDS + 2u], records[(patch_index)*RECORD_WORDS + 3u], \
                        records[(patch_index)*RECORD_WORDS + 4u])

FUNCTION TrianglePatch make_triangle_patch(uint flags, uint factor0, uint factor1, uint factor2, uint inside) {
    TrianglePatch p;
    const uint odd = flags >> RECORD_ODD_SHIFT;
    p.flags = flags;
    p.level = factor0;
    p.edge0 = make_edge(factor0, odd & 1u);
    p.edge1 = make_edge(factor1, (odd >> 1u) & 1u);
    p.edge2 = make_edge(factor2, (odd >> 2u) & 1u);
    p.inside = make_edge(inside, (odd >> 3u) & 1u);
    p.outer_points = p.edge0.points + p.edge1.points + p.edge2.points - 3u;
    p.rings = (p.inside.points >> 1u) - 1u;
    return p;
}

FUNCTION uint triangle_point_count(TrianglePatch p) {
    if ((p.flags & RECORD_CULLED) != 0u) {
        return 0u;
    }
    if ((p.flags & RECORD_SINGLE) != 0u) {
        return 3u;
    }
    if ((p.flags & RECORD_UNIFORM) != 0u) {
        return ((p.level + 1u) * (p.level + 2u)) >> 1u;
    }
    const uint r = p.rings;
    return p.outer_points + (p.inside.odd != 0u ? 3u * r * r : 3u * r * (r + 1u) + 1u);
}

FUNCTION uint triangle_triangle_count(TrianglePatch p) {
    if ((p.flags & RECORD_CULLED) != 0u) {
        return 0u;
    }
    if ((p.flags & RECORD_SINGLE) != 0u) {
        return 1u;
    }
    if ((p.flags & RECORD_UNIFORM) != 0u) {
        return p.level * p.level;
    }
    // Ring 1 has outer_points + 3 (N - 3) triangles, ring j > 1 has 6 (N - 2j), an odd centre one more.
    const uint n = p.inside.points;
    const uint last = (n - 1u) >> 1u;  // the innermost row of triangles: j = 2..last
    const uint inner = 6u * ((last - 1u) * n - (last * (last + 1u) - 2u));
    return p.outer_points + 3u * (n - 3u) + inner + p.inside.odd;
}

/// Ring r >= 1 of points begins 3 (r - 1) (N - 1 - r) points after the outer ring.
FUNCTION uint ring_start(uint r, uint points) {
    return 3u * (r - 1u) * (points - 1u - r);
}

/// Row y of the even grid of a level begins at this point: y rows of level + 1, level, ... points.
FUNCTION uint uniform_row_start(uint y, uint level) {
    return y * (level + 1u) - ((y * (y - 1u)) >> 1u);
}

/// Point i of the even grid: rows of constant v from v = 0 up, u ascending.
FUNCTION DomainPoint uniform_point(uint level, uint i) {
    uint y = 0u;
    for (uint bit = 64u; bit > 0u; bit = bit >> 1u) {
        const uint candidate = y + bit;
        y = candidate <= level && uniform_row_start(candidate, level) <= i ? candidate : y;
    }
    const uint x = i - uniform_row_start(y, level);
    // On the edge w = 0 v must be what is left of u, for the two come from one symmetric coordinate.
    const uint u = even_coordinate(x, level);
    return make_domain_point(u, x + y == level ? 65536u - u : even_coordinate(y, level));
}

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
        side.edge = choose_edge(number, p.edge0, p.edge1, p.edge2);
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

/// True where the patch is made of ring sides and, where its inside factor is even, a centre that comes last.
FUNCTION bool triangle_has_rings(TrianglePatch p) {
    return (p.flags & (RECORD_CULLED | RECORD_SINGLE | RECORD_UNIFORM)) == 0u;
}

FUNCTION DomainPoint triangle_centre() {
    return make_domain_point(0x5555u, 0x5555u);
}

FUNCTION DomainPoint triangle_point(TrianglePatch p, uint i) {
    if ((p.flags & RECORD_SINGLE) != 0u) {
        return make_domain_point(i == 2u ? 65536u : 0u, i == 0u ? 65536u : 0u);
    }
    if ((p.flags & RECORD_UNIFORM) != 0u) {
        return uniform_point(p.level, i);
    }
    if (i < p.outer_points) {
        const uint start1 = p.edge0.points - 1u;
        const uint start2 = start1 + p.edge1.points - 1u;
        const RingSide side = triangle_ring_side(p, 0u, i < start1 ? 0u : (i < start2 ? 1u : 2u));
        return ring_side_point(side, i - side.first);
    }
    const uint n = p.inside.points;
    const uint inner = i - p.outer_points;
    uint r = 1u;
    for (uint bit = 16u; bit > 0u; bit = bit >> 1u) {
        const uint candidate = r + bit;
        r = candidate <= p.rings && ring_start(candidate, n) <= inner ? candidate : r;
    }
    const uint segments = n - 1u - 2u * r;
    const uint q = inner - ring_start(r, n);
    if (r > p.rings || q >= 3u * segments) {
        return triangle_centre();
    }
    const RingSide side = triangle_ring_side(p, r, q < segments ? 0u : (q < 2u * segments ? 1u : 2u));
    return ring_side_point(side, i - side.first);
}

/// Triangle t of the even grid.
FUNCTION Triangle uniform_triangle(uint level, uint t) {
    // Row y has 2 (level - y) - 1 triangles and begins after y (2 level - y) of them.
    uint y = 0u;
    for (uint bit = 32u; bit > 0u; bit = bit >> 1u) {
        const uint candidate = y + bit;
        y = candidate < level && candidate * (2u * level - candidate) <= t ? candidate : y;
    }
    const uint k = t - y * (2u * level - y);
    const uint x = k >> 1u;
    const uint low = uniform_row_start(y, level) + x;
    const uint high = uniform_row_start(y + 1u, level) + x;
    return (k & 1u) == 0u ? make_triangle(low, low + 1u, high) : make_triangle(low + 1u, high + 1u, high);
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

/// Triangle t of row 1.
FUNCTION Triangle triangle_outer_triangle(TrianglePatch p, uint t) {
    const uint inner_segments = p.inside.points - 3u;
    const uint start1 = p.edge0.points - 1u;
    const uint start2 = start1 + p.edge1.points - 1u;
    const uint count0 = start1 + inner_segments;
    const uint count01 = start2 + 2u * inner_segments;
    const uint side = t < count0 ? 0u : (t < count01 ? 1u : 2u);
    const uint s = t - (side == 0u ? 0u : (side == 1u ? count0 : count01));
    const Edge edge = choose_edge(side, p.edge0, p.edge1, p.edge2);
    const Triangle row = transition_triangle(s, edge.half_points - edge.odd, edge.odd,
                                             p.inside.half_points - p.inside.odd, p.inside.odd);
    return place_row(row, make_ring(0u, p.outer_points), side == 0u ? 0u : (side == 1u ? start1 : start2),
                     make_ring(p.outer_points, 3u * inner_segments), side * inner_segments);
}

/// The innermost row of triangles; the rows are 1..this.
FUNCTION uint triangle_last_row(TrianglePatch p) {
    return (p.inside.points - 1u) >> 1u;
}

/// Triangles of row 1, which come first.
FUNCTION uint triangle_outer_count(TrianglePatch p) {
    return p.outer_points + 3u * (p.inside.points - 3u);
}

/// The one triangle over the last ring, last of all, where the inside factor is odd.
FUNCTION Triangle triangle_odd_centre(TrianglePatch p) {
    const uint b = p.outer_points + ring_start(p.rings, p.inside.points);
    return make_triangle(b, b + 1u, b + 2u);
}

/// Triangle t as point indices of the patch, with positive area where u points right and v up.
FUNCTION Triangle triangle_triangle(TrianglePatch p, uint t) {
    if ((p.flags & RECORD_SINGLE) != 0u) {
        return make_triangle(0u, 1u, 2u);
    }
    if ((p.flags & RECORD_UNIFORM) != 0u) {
        return uniform_triangle(p.level, t);
    }
    const uint outer = triangle_outer_count(p);
    if (t < outer) {
        return triangle_outer_triangle(p, t);
    }
    const uint n = p.inside.points;
    const uint inner = t - outer;
    const uint last = triangle_last_row(p);
    uint j = 2u;
    for (uint bit = 16u; bit > 0u; bit = bit >> 1u) {
        const uint candidate = j + bit;
        const uint before = 6u * ((candidate - 2u) * n + 2u - (candidate - 1u) * candidate);
        j = candidate <= last && before <= inner ? candidate : j;
    }
    const RowSide first_side = triangle_row_side(p, j, 0u);
    const uint s = t - first_side.first;
    if (j > last || s >= 3u * first_side.triangles) {
        return triangle_odd_centre(p);
    }
    const uint number = s < first_side.triangles ? 0u : (s < 2u * first_side.triangles ? 1u : 2u);
    const RowSide side = triangle_row_side(p, j, number);
    return row_side_triangle(side, t - side.first);
}

KERNELS_END

#endif
