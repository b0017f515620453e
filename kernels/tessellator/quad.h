// The quad domain: points and triangles of a patch by their index, in the order of the D3D11 tessellator.
//
//   (0,1)  V=1  (1,1)     Factors: edges U=0, V=0, U=1, V=1, inside U, inside V. Points: the outer ring (edges in that
//      +--------+         order, from (0,1) down and around, each without its last point), then ring after ring
//      inwards.
//  U=0 |        | U=1     Where the inside axis with fewer points has an even factor, a single row comes last.
//      +--------+
//   (0,0)  V=0  (1,0)
#ifndef TESSERA_TESSELLATOR_QUAD_H
#define TESSERA_TESSELLATOR_QUAD_H

#include "tessellator/ring_window.h"
#include "tessellator/row.h"

KERNELS_BEGIN

/// What the record of a quad patch says, unpacked once per patch.
STRUCT(QuadPatch) {
    uint flags;
    uint level;  // of a uniform pattern
    Edge edge0;
    Edge edge1;
    Edge edge2;
    Edge edge3;
    Edge inside_u;
    Edge inside_v;
    uint outer_points;  // points of the outer ring
    uint rings;         // inner rings of points, without a final row
    uint final_row;     // 1: the smaller axis is even and a single row lies in the middle
};

/// Reads a patch record from a buffer.
#define LOAD_QUAD_PATCH(records, patch_index)                                                           \
    make_quad_patch(records[(patch_index)*RECORD_WORDS], records[(patch_index)*RECORD_WORDS + 1u],      \
                    records[(patch_index)*RECORD_WORDS + 2u], records[(patch_index)*RECORD_WORDS + 3u], \
                    records[(patch_index)*RECORD_WORDS + 4u], records[(patch_index)*RECORD_WORDS + 5u], \
                    records[(patch_index)*RECORD_WORDS + 6u])

FUNCTION QuadPatch make_quad_patch(uint flags, uint factor0, uint factor1, uint factor2, uint factor3, uint inside_u,
                                   uint inside_v) {
    QuadPatch p;
    const uint odd = flags >> RECORD_ODD_SHIFT;
    p.flags = flags;
    p.level = factor0;
    p.edge0 = make_edge(factor0, odd & 1u);
    p.edge1 = make_edge(factor1, (odd >> 1u) & 1u);
    p.edge2 = make_edge(factor2, (odd >> 2u) & 1u);
    p.edge3 = make_edge(factor3, (odd >> 3u) & 1u);
    p.inside_u = make_edge(inside_u, (odd >> 4u) & 1u);
    p.inside_v = make_edge(inside_v, (odd >> 5u) & 1u);
    p.outer_points = p.edge0.points + p.edge1.points + p.edge2.points + p.edge3.points - 4u;
    const bool u_is_minor = p.inside_u.points <= p.inside_v.points;
    const uint minor = u_is_minor ? p.inside_u.points : p.inside_v.points;
    p.rings = (minor >> 1u) - 1u;
    p.final_row = minor & 1u;
    return p;
}

FUNCTION uint quad_point_count(QuadPatch p) {
    if ((p.flags & RECORD_CULLED) != 0u) {
        return 0u;
    }
    if ((p.flags & RECORD_SINGLE) != 0u) {
        return 4u;
    }
    if ((p.flags & RECORD_UNIFORM) != 0u) {
        return (p.level + 1u) * (p.level + 1u);
    }
    return p.outer_points + (p.inside_u.points - 2u) * (p.inside_v.points - 2u);
}

FUNCTION uint quad_triangle_count(QuadPatch p) {
    if ((p.flags & RECORD_CULLED) != 0u) {
        return 0u;
    }
    if ((p.flags & RECORD_SINGLE) != 0u) {
        return 2u;
    }
    if ((p.flags & RECORD_UNIFORM) != 0u) {
        return 2u * p.level * p.level;
    }
    const uint u = p.inside_u.points - 3u;
    const uint v = p.inside_v.points - 3u;
    return p.outer_points + 2u * u * v + 2u * u + 2u * v;
}

/// Ring r >= 1 begins this many points after the outer ring; `sum` is N_U + N_V.
FUNCTION uint quad_ring_start(uint r, uint sum) {
    return 2u * (r - 1u) * (sum - 2u - 2u * r);
}

FUNCTION uint choose_of_four(uint side, uint a, uint b, uint c, uint d) {
    const bool odd = (side & 1u) != 0u;  // by bits, for compilers make a switch of comparisons
    return (side & 2u) == 0u ? (odd ? b : a) : (odd ? d : c);
}

/// Position q along a side of an axis of n points that runs down (sides 0 and 3) or up (sides 1 and 2).
FUNCTION uint directed_position(uint side, uint r, uint k, uint n) {
    return side == 0u || side == 3u ? n - 1u - r - k : r + k;
}

/// True where the patch is made of rings; else it is culled, two triangles or an even grid.
FUNCTION bool quad_has_rings(QuadPatch p) {
    return (p.flags & (RECORD_CULLED | RECORD_SINGLE | RECORD_UNIFORM)) == 0u;
}

/// The rings of a run of points that begins with point i, which may be on the outer ring.
FUNCTION RingWindow quad_point_window(QuadPatch p, uint i) {
    const uint sum = p.inside_u.points + p.inside_v.points;
    const uint inner = i < p.outer_points ? 0u : i - p.outer_points;
#define POINT_RING_START(r) quad_ring_start(r, sum)
    FIND_RING_WINDOW(window, 1u, p.rings + p.final_row, inner, POINT_RING_START);
#undef POINT_RING_START
    return window;
}

/// Point i of a patch with rings, in the run that `window` belongs to. Branch-free.
FUNCTION DomainPoint quad_ring_point(QuadPatch p, RingWindow window, uint i) {
    // On the outer ring:
    const uint start1 = p.edge0.points - 1u;
    const uint start2 = start1 + p.edge1.points - 1u;
    const uint start3 = start2 + p.edge2.points - 1u;
    const uint outer_side = i < start1 ? 0u : (i < start2 ? 1u : (i < start3 ? 2u : 3u));
    const Edge edge = choose_edge(outer_side >= 2u, choose_edge(outer_side == 1u, p.edge0, p.edge1),
                                  choose_edge(outer_side == 3u, p.edge2, p.edge3));
    const uint outer_k = i - choose_of_four(outer_side, 0u, start1, start2, start3);
    const uint c = edge_coordinate(edge, directed_position(outer_side, 0u, outer_k, edge.points));
    const uint outer_u = choose_of_four(outer_side, 0u, c, 65536u, c);
    const uint outer_v = choose_of_four(outer_side, c, 0u, c, 65536u);
    // On an inner one, or on the final row: up along U, or down along V.
    const uint nu = p.inside_u.points;
    const uint nv = p.inside_v.points;
    const uint inner = i - p.outer_points;
    const uint r = ring_of(window, inner);
    const uint q = inner - ring_start_of(window, inner);
    const bool on_row = r > p.rings;
    const uint su = nu - 1u - 2u * r;
    const uint sv = nv - 1u - 2u * r;
    const uint ring_side = q < sv ? 0u : (q < sv + su ? 1u : (q < 2u * sv + su ? 2u : 3u));
    const uint side = on_row ? (nu > nv ? 1u : 0u) : ring_side;
    const uint k = on_row ? q : q - choose_of_four(side, 0u, sv, sv + su, 2u * sv + su);
    const uint u_at =
        choose_of_four(side, r, directed_position(1u, r, k, nu), nu - 1u - r, directed_position(3u, r, k, nu));
    const uint v_at =
        choose_of_four(side, directed_position(0u, r, k, nv), r, directed_position(2u, r, k, nv), nv - 1u - r);
    const uint inner_u = on_row && nu <= nv ? 0x8000u : edge_coordinate(p.inside_u, u_at);
    const uint inner_v = on_row && nu > nv ? 0x8000u : edge_coordinate(p.inside_v, v_at);
    const bool on_outer = i < p.outer_points;
    return make_domain_point(on_outer ? outer_u : inner_u, on_outer ? outer_v : inner_v);
}

/// Point i of a patch without rings.
FUNCTION DomainPoint quad_plain_point(QuadPatch p, uint i) {
    if ((p.flags & RECORD_UNIFORM) != 0u) {
        const uint row = p.level + 1u;
        return make_domain_point(even_coordinate(i % row, p.level), even_coordinate(i / row, p.level));
    }
    return make_domain_point(i == 1u || i == 2u ? 65536u : 0u, i >= 2u ? 65536u : 0u);
}

/// Inner ring r of points, the folded final row included.
FUNCTION Ring quad_ring(QuadPatch p, uint r) {
    const uint nu = p.inside_u.points;
    const uint nv = p.inside_v.points;
    Ring ring = make_ring(p.outer_points + quad_ring_start(r, nu + nv), 2u * (nu + nv - 2u - 4u * r));
    ring.folded = r > p.rings ? 1u : 0u;
    return ring;
}

/// Where a side begins on a ring with sides of sv, su, sv, su segments.
FUNCTION uint quad_side_offset(uint side, uint su, uint sv) {
    return choose_of_four(side, 0u, sv, sv + su, 2u * sv + su);
}

/// Triangles of the first row, between the outer ring and the first inner one.
FUNCTION uint quad_outer_count(QuadPatch p) {
    return p.outer_points + 2u * (p.inside_u.points + p.inside_v.points - 6u);
}

/// Triangle t of the first row.
FUNCTION Triangle quad_outer_triangle(QuadPatch p, uint t) {
    const uint su = p.inside_u.points - 3u;
    const uint sv = p.inside_v.points - 3u;
    const uint start1 = p.edge0.points - 1u;
    const uint start2 = start1 + p.edge1.points - 1u;
    const uint start3 = start2 + p.edge2.points - 1u;
    const uint end0 = start1 + sv;
    const uint end1 = start2 + sv + su;
    const uint end2 = start3 + 2u * sv + su;
    const uint side = t < end0 ? 0u : (t < end1 ? 1u : (t < end2 ? 2u : 3u));
    const uint s = t - choose_of_four(side, 0u, end0, end1, end2);
    const bool along_v = (side & 1u) == 0u;
    const uint inner_half = along_v ? p.inside_v.half_points - p.inside_v.odd : p.inside_u.half_points - p.inside_u.odd;
    const uint inner_odd = along_v ? p.inside_v.odd : p.inside_u.odd;
    const uint outer_odd = choose_of_four(side, p.edge0.odd, p.edge1.odd, p.edge2.odd, p.edge3.odd);
    const uint outer_half =
        choose_of_four(side, p.edge0.half_points, p.edge1.half_points, p.edge2.half_points, p.edge3.half_points) -
        outer_odd;
    const Triangle row = transition_triangle(s, outer_half, outer_odd, inner_half, inner_odd);
    return place_row(row, make_ring(0u, p.outer_points), choose_of_four(side, 0u, start1, start2, start3),
                     quad_ring(p, 1u), quad_side_offset(side, su, sv));
}

/// Triangle t of the strip of quads in the middle, where the smaller axis is odd.
FUNCTION Triangle quad_strip_triangle(QuadPatch p, uint t) {
    const uint nu = p.inside_u.points;
    const uint nv = p.inside_v.points;
    const Ring ring = quad_ring(p, p.rings);
    const uint b = ring.start;
    const uint s = (ring.points >> 1u) - 1u;  // quads of the strip
    const uint j = t >> 1u;
    const bool second = (t & 1u) == 1u;
    const bool along_u = nu > nv;
    const uint o = b + j + (along_u ? 1u : 0u);
    const uint far = b + 2u * s + 1u - j;
    const uint i = along_u ? (j == 0u ? b : far + 1u) : far;
    const uint next = along_u ? far : far - 1u;
    // Along V the diagonal turns once: in the middle quad and before it where the factor along V is odd.
    const bool odd_v = !along_u && p.inside_v.odd != 0u;
    const bool middle = odd_v && j == (s >> 1u);
    const uint a = odd_v && (middle || !second) ? o : i;
    const uint b1 = middle && !second ? next : (second || odd_v ? o + 1u : o);
    const uint c = second ? next : (odd_v ? i : o + 1u);
    return make_triangle(a, b1, c);
}

/// Row j >= 2, between rings j - 1 and j, begins so many triangles after the first row; `sum` is N_U + N_V.
FUNCTION uint quad_row_start(uint j, uint sum) {
    return 4u * ((j - 2u) * sum + 4u - 2u * (j - 1u) * j);
}

/// The rows of a run of triangles that begins with triangle t, none of the first row.
FUNCTION RingWindow quad_row_window(QuadPatch p, uint t) {
    const uint sum = p.inside_u.points + p.inside_v.points;
    const uint inner = t - quad_outer_count(p);
#define QUAD_ROW_START(j) quad_row_start(j, sum)
    FIND_RING_WINDOW(window, 2u, p.rings + p.final_row, inner, QUAD_ROW_START);
#undef QUAD_ROW_START
    return window;
}

/// Triangle t of the rows after the first and of the strip in the middle, in the run that `window` belongs to.
/// Branch-free.
FUNCTION Triangle quad_inner_triangle(QuadPatch p, RingWindow window, uint t) {
    const uint sum = p.inside_u.points + p.inside_v.points;
    const uint inner = t - quad_outer_count(p);
    const uint last = p.rings + p.final_row;
    const uint j = ring_of(window, inner);
    const uint in_row = inner - ring_start_of(window, inner);
    const uint row_count = 4u * (sum - 4u * j);
    const bool on_strip = j > last || in_row >= row_count;
    const Triangle strip = quad_strip_triangle(p, j > last ? inner : in_row - row_count);
    const uint mu = p.inside_u.points - 2u * j;  // points of ring j's side along u
    const uint mv = p.inside_v.points - 2u * j;
    const uint end0 = 2u * mv;
    const uint end1 = end0 + 2u * mu;
    const uint end2 = end1 + 2u * mv;
    const uint side = in_row < end0 ? 0u : (in_row < end1 ? 1u : (in_row < end2 ? 2u : 3u));
    const uint s = in_row - choose_of_four(side, 0u, end0, end1, end2);
    const Triangle row =
        place_row(ring_triangle(s, (side & 1u) == 0u ? mv : mu), quad_ring(p, j - 1u),
                  quad_side_offset(side, mu + 1u, mv + 1u), quad_ring(p, j), quad_side_offset(side, mu - 1u, mv - 1u));
    return choose_triangle(on_strip, strip, row);
}

FUNCTION DomainPoint quad_point(QuadPatch p, uint i) {
    if (quad_has_rings(p)) {
        return quad_ring_point(p, quad_point_window(p, i), i);
    }
    return quad_plain_point(p, i);
}

/// Triangle t of a patch without rings.
FUNCTION Triangle quad_plain_triangle(QuadPatch p, uint t) {
    const bool is_grid = (p.flags & RECORD_UNIFORM) != 0u;
    const uint level = is_grid ? p.level : 1u;
    const uint cell = t >> 1u;
    const uint low = (cell / level) * (level + 1u) + cell % level;
    const uint high = low + level + 1u;
    const Triangle grid =
        (t & 1u) == 0u ? make_triangle(low, low + 1u, high) : make_triangle(low + 1u, high + 1u, high);
    const Triangle pair = t == 0u ? make_triangle(0u, 1u, 3u) : make_triangle(1u, 2u, 3u);
    return choose_triangle(is_grid, grid, pair);
}

KERNELS_END

#endif
