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
    return side == 0u ? a : (side == 1u ? b : (side == 2u ? c : d));
}

/// Position q along a side of an axis of n points that runs down (sides 0 and 3) or up (sides 1 and 2).
FUNCTION uint directed_position(uint side, uint r, uint k, uint n) {
    return side == 0u || side == 3u ? n - 1u - r - k : r + k;
}

FUNCTION DomainPoint quad_outer_point(QuadPatch p, uint i) {
    const uint start1 = p.edge0.points - 1u;
    const uint start2 = start1 + p.edge1.points - 1u;
    const uint start3 = start2 + p.edge2.points - 1u;
    const uint side = i < start1 ? 0u : (i < start2 ? 1u : (i < start3 ? 2u : 3u));
    const uint k = i - choose_of_four(side, 0u, start1, start2, start3);
    Edge edge = choose_edge(side, p.edge0, p.edge1, p.edge2);
    if (side == 3u) {
        edge = p.edge3;
    }
    const uint c = edge_coordinate(edge, directed_position(side, 0u, k, edge.points));
    return make_domain_point(choose_of_four(side, 0u, c, 65536u, c), choose_of_four(side, c, 0u, c, 65536u));
}

FUNCTION DomainPoint quad_point(QuadPatch p, uint i) {
    if ((p.flags & RECORD_SINGLE) != 0u) {
        return make_domain_point(i == 1u || i == 2u ? 65536u : 0u, i >= 2u ? 65536u : 0u);
    }
    if ((p.flags & RECORD_UNIFORM) != 0u) {
        const uint row = p.level + 1u;
        return make_domain_point(even_coordinate(i % row, p.level), even_coordinate(i / row, p.level));
    }
    if (i < p.outer_points) {
        return quad_outer_point(p, i);
    }
    const uint nu = p.inside_u.points;
    const uint nv = p.inside_v.points;
    const uint inner = i - p.outer_points;
    const uint last = p.rings + p.final_row;
    uint r = 1u;
    for (uint bit = 16u; bit > 0u; bit = bit >> 1u) {
        const uint candidate = r + bit;
        r = candidate <= last && quad_ring_start(candidate, nu + nv) <= inner ? candidate : r;
    }
    const uint q = inner - quad_ring_start(r, nu + nv);
    if (r > p.rings) {
        // The final row: up along U, or down along V.
        return nu > nv ? make_domain_point(edge_coordinate(p.inside_u, r + q), 0x8000u)
                       : make_domain_point(0x8000u, edge_coordinate(p.inside_v, nv - 1u - r - q));
    }
    const uint su = nu - 1u - 2u * r;
    const uint sv = nv - 1u - 2u * r;
    const uint side = q < sv ? 0u : (q < sv + su ? 1u : (q < 2u * sv + su ? 2u : 3u));
    const uint k = q - choose_of_four(side, 0u, sv, sv + su, 2u * sv + su);
    const uint u =
        choose_of_four(side, r, directed_position(1u, r, k, nu), nu - 1u - r, directed_position(3u, r, k, nu));
    const uint v =
        choose_of_four(side, directed_position(0u, r, k, nv), r, directed_position(2u, r, k, nv), nv - 1u - r);
    return make_domain_point(edge_coordinate(p.inside_u, u), edge_coordinate(p.inside_v, v));
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

/// Triangle t of the first row, between the outer ring and the first inner one.
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
    if (nu > nv) {
        const uint o = b + 1u + j;
        const uint i = j == 0u ? b : b + 2u * s + 2u - j;
        const uint next = b + 2u * s + 1u - j;
        return second ? make_triangle(i, o + 1u, next) : make_triangle(i, o, o + 1u);
    }
    const uint o = b + j;
    const uint i = b + 2u * s + 1u - j;
    if (p.inside_v.odd == 0u) {
        return second ? make_triangle(i, o + 1u, i - 1u) : make_triangle(i, o, o + 1u);
    }
    if (j == (s >> 1u)) {
        return second ? make_triangle(o, o + 1u, i - 1u) : make_triangle(o, i - 1u, i);
    }
    return second ? make_triangle(i, o + 1u, i - 1u) : make_triangle(o, o + 1u, i);
}

/// Triangle t as point indices of the patch, with positive area where u points right and v up.
FUNCTION Triangle quad_triangle(QuadPatch p, uint t) {
    if ((p.flags & RECORD_SINGLE) != 0u) {
        return t == 0u ? make_triangle(0u, 1u, 3u) : make_triangle(1u, 2u, 3u);
    }
    if ((p.flags & RECORD_UNIFORM) != 0u) {
        const uint cell = t >> 1u;
        const uint low = (cell / p.level) * (p.level + 1u) + cell % p.level;
        const uint high = low + p.level + 1u;
        return (t & 1u) == 0u ? make_triangle(low, low + 1u, high) : make_triangle(low + 1u, high + 1u, high);
    }
    const uint sum = p.inside_u.points + p.inside_v.points;
    const uint first_row = p.outer_points + 2u * (sum - 6u);
    if (t < first_row) {
        return quad_outer_triangle(p, t);
    }
    const uint inner = t - first_row;
    // Row j >= 2 lies between rings j - 1 and j and begins after 4 ((j - 2) (N_U + N_V) - 2 (j - 1) j + 4) triangles.
    const uint last = p.rings + p.final_row;
    uint j = 2u;
    for (uint bit = 16u; bit > 0u; bit = bit >> 1u) {
        const uint candidate = j + bit;
        const uint before = 4u * ((candidate - 2u) * sum + 4u - 2u * (candidate - 1u) * candidate);
        j = candidate <= last && before <= inner ? candidate : j;
    }
    const uint before = 4u * ((j - 2u) * sum + 4u - 2u * (j - 1u) * j);
    const uint in_row = inner - before;
    if (j > last || in_row >= 4u * (sum - 4u * j)) {
        return quad_strip_triangle(p, j > last ? inner : in_row - 4u * (sum - 4u * j));
    }
    const uint mu = p.inside_u.points - 2u * j;  // points of ring j's side along u
    const uint mv = p.inside_v.points - 2u * j;
    const uint end0 = 2u * mv;
    const uint end1 = end0 + 2u * mu;
    const uint end2 = end1 + 2u * mv;
    const uint side = in_row < end0 ? 0u : (in_row < end1 ? 1u : (in_row < end2 ? 2u : 3u));
    const uint s = in_row - choose_of_four(side, 0u, end0, end1, end2);
    const Triangle row = ring_triangle(s, (side & 1u) == 0u ? mv : mu);
    return place_row(row, quad_ring(p, j - 1u), quad_side_offset(side, mu + 1u, mv + 1u), quad_ring(p, j),
                     quad_side_offset(side, mu - 1u, mv - 1u));
}

KERNELS_END

#endif
