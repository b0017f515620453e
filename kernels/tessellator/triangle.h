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

#include "tessellator/ring_window.h"
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

/// True where the patch is made of rings; else it is culled, a single triangle or an even grid.
FUNCTION bool triangle_has_rings(TrianglePatch p) {
    return (p.flags & (RECORD_CULLED | RECORD_SINGLE | RECORD_UNIFORM)) == 0u;
}

/// The rings of a run of points that begins with point i, which may be on the outer ring.
FUNCTION RingWindow triangle_point_window(TrianglePatch p, uint i) {
    const uint inner = i < p.outer_points ? 0u : i - p.outer_points;
#define POINT_RING_START(r) ring_start(r, p.inside.points)
    FIND_RING_WINDOW(window, 1u, p.rings, inner, POINT_RING_START);
#undef POINT_RING_START
    return window;
}

/// Point i of a patch with rings, in the run that `window` belongs to. Branch-free.
FUNCTION DomainPoint triangle_ring_point(TrianglePatch p, RingWindow window, uint i) {
    const uint n = p.inside.points;
    const bool on_outer = i < p.outer_points;
    const uint start1 = p.edge0.points - 1u;
    const uint start2 = start1 + p.edge1.points - 1u;
    const uint inner = i - p.outer_points;
    const uint r = ring_of(window, inner);
    const uint segments = n - 1u - 2u * r;
    const uint q = inner - ring_start_of(window, inner);
    const bool is_centre = !on_outer && (r > p.rings || q >= 3u * segments);
    const uint outer_side = i < start1 ? 0u : (i < start2 ? 1u : 2u);
    const uint inner_side = q < segments ? 0u : (q < 2u * segments ? 1u : 2u);
    const uint side = on_outer ? outer_side : inner_side;
    const Edge outer_edge = choose_edge(outer_side == 2u, choose_edge(outer_side == 1u, p.edge0, p.edge1), p.edge2);
    const Edge edge = choose_edge(on_outer, p.inside, outer_edge);
    const uint side_start = on_outer ? (side == 0u ? 0u : (side == 1u ? start1 : start2)) : side * segments;
    const uint k = (on_outer ? i : q) - side_start;
    // Side 1 runs up along its edge, the others down; inner rings leave out r points at either end.
    const uint skipped = on_outer ? 0u : r;
    const uint along_at = side == 1u ? skipped + k : edge.points - 1u - skipped - k;
    const uint across = on_outer ? 0u : (edge_coordinate(p.inside, r) * 0xaaaau + 0x8000u) >> 16u;
    const uint along = edge_coordinate(edge, along_at) - ((across + 1u) >> 1u);
    const uint u = side == 0u ? across : along;
    const uint v = side == 0u ? along : (side == 1u ? across : 65536u - along - across);
    return make_domain_point(is_centre ? 0x5555u : u, is_centre ? 0x5555u : v);
}

/// Point i of a patch without rings.
FUNCTION DomainPoint triangle_plain_point(TrianglePatch p, uint i) {
    if ((p.flags & RECORD_UNIFORM) != 0u) {
        return uniform_point(p.level, i);
    }
    return make_domain_point(i == 2u ? 65536u : 0u, i == 0u ? 65536u : 0u);
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

/// The triangles come in rows: row j lies between rings j - 1 and j of points. Row 1, at the outer ring, joins two
/// factors, the others are regular. So many triangles has row 1:
FUNCTION uint triangle_outer_count(TrianglePatch p) {
    return p.outer_points + 3u * (p.inside.points - 3u);
}

/// Where triangle t of row 1 lies.
STRUCT(OuterPlace) {
    uint side;
    uint s;  // its number on the side
    Edge edge;
    Transition row;
    uint outer_offset;  // where the side begins on its rings
    uint inner_offset;
};

FUNCTION OuterPlace triangle_outer_place(TrianglePatch p, uint t) {
    OuterPlace place;
    const uint inner_segments = p.inside.points - 3u;
    const uint start1 = p.edge0.points - 1u;
    const uint start2 = start1 + p.edge1.points - 1u;
    const uint count0 = start1 + inner_segments;
    const uint count01 = start2 + 2u * inner_segments;
    const uint side = t < count0 ? 0u : (t < count01 ? 1u : 2u);
    place.side = side;
    place.s = t - (side == 0u ? 0u : (side == 1u ? count0 : count01));
    place.edge = choose_edge(side == 2u, choose_edge(side == 1u, p.edge0, p.edge1), p.edge2);
    place.row = make_transition(place.edge.half_points - place.edge.odd, place.edge.odd,
                                p.inside.half_points - p.inside.odd, p.inside.odd);
    place.outer_offset = side == 0u ? 0u : (side == 1u ? start1 : start2);
    place.inner_offset = side * inner_segments;
    return place;
}

/// The triangle that a step (row.h) makes there.
FUNCTION Triangle triangle_outer_stepped(TrianglePatch p, OuterPlace place, uint step) {
    return place_row(stepped_triangle(place.row, place.s, step), make_ring(0u, p.outer_points), place.outer_offset,
                     make_ring(p.outer_points, 3u * (p.inside.points - 3u)), place.inner_offset);
}

/// Triangle t of row 1.
FUNCTION Triangle triangle_outer_triangle(TrianglePatch p, uint t) {
    const OuterPlace place = triangle_outer_place(p, t);
    return triangle_outer_stepped(
        p, place,
        transition_step(transition_at(place.row, place.s), place.row.outer_half, p.inside.half_points - p.inside.odd));
}

/// Row j >= 2 of triangles begins so many after the first row.
FUNCTION uint triangle_row_start(uint j, uint points) {
    return 6u * ((j - 2u) * points + 2u - (j - 1u) * j);
}

/// The rows of a run of triangles that begins with triangle t, none of the first row.
FUNCTION RingWindow triangle_row_window(TrianglePatch p, uint t) {
    const uint n = p.inside.points;
    const uint inner = t - triangle_outer_count(p);
#define TRIANGLE_ROW_START(j) triangle_row_start(j, n)
    FIND_RING_WINDOW(window, 2u, (n - 1u) >> 1u, inner, TRIANGLE_ROW_START);
#undef TRIANGLE_ROW_START
    return window;
}

/// Triangle t of the rows after the first, or the one over the last ring that an odd inside factor leaves, in the run
/// that `window` belongs to. Branch-free.
FUNCTION Triangle triangle_inner_triangle(TrianglePatch p, RingWindow window, uint t) {
    const uint n = p.inside.points;
    const uint inner = t - triangle_outer_count(p);
    const uint last = (n - 1u) >> 1u;  // the innermost row
    const uint j = ring_of(window, inner);
    const uint in_row = inner - ring_start_of(window, inner);
    const uint points = n - 2u * j;  // of the inner ring on each side, both corners included
    const bool is_centre = j > last || in_row >= 6u * points;
    const uint side = in_row < 2u * points ? 0u : (in_row < 4u * points ? 1u : 2u);
    const uint outer_start = p.outer_points + ring_start(j - 1u, n);
    const uint inner_start = outer_start + 3u * (points + 1u);
    const Triangle row =
        place_row(ring_triangle(in_row - side * 2u * points, points), make_ring(outer_start, 3u * (points + 1u)),
                  side * (points + 1u), make_ring(inner_start, 3u * (points - 1u)), side * (points - 1u));
    const uint b = p.outer_points + ring_start(p.rings, n);
    return choose_triangle(is_centre, make_triangle(b, b + 1u, b + 2u), row);
}

FUNCTION DomainPoint triangle_point(TrianglePatch p, uint i) {
    if (triangle_has_rings(p)) {
        return triangle_ring_point(p, triangle_point_window(p, i), i);
    }
    return triangle_plain_point(p, i);
}

/// Triangle t of a patch without rings.
FUNCTION Triangle triangle_plain_triangle(TrianglePatch p, uint t) {
    if ((p.flags & RECORD_UNIFORM) != 0u) {
        return uniform_triangle(p.level, t);
    }
    return make_triangle(0u, 1u, 2u);
}

KERNELS_END

#endif
