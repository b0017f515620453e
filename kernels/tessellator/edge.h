// One edge of a domain: how many points a factor puts on it and where, and the order in which a row of triangles between
// an edge and the row inside it is listed. Unsigned 32-bit arithmetic only.
// Source: D3D11.3 functional specification, 11.7.
#ifndef TESSERA_TESSELLATOR_EDGE_H
#define TESSERA_TESSELLATOR_EDGE_H

#include "layout.h"

KERNELS_BEGIN

/// What a resolved factor says about its edge. Coordinates are 16.16: 65536 is the far end.
STRUCT(Edge) {
    uint odd;            // 1: an odd number of segments
    uint half_points;    // points up to the middle, rounded up
    uint points;         // points on the edge, both ends included
    uint fraction;       // 16 bits: how far the factor is from the lower of the two patterns it blends
    uint split;          // the point that the higher pattern has and the lower one lacks
    uint inverse_floor;  // 65536 / segments of the lower pattern, rounded
    uint inverse_ceil;   // likewise of the higher one
};

/// Index of the highest set bit; 0 for 0. Values up to 6 bits.
FUNCTION uint highest_bit(uint x) {
    return (x >= 32u ? 5u : (x >= 16u ? 4u : (x >= 8u ? 3u : (x >= 4u ? 2u : (x >= 2u ? 1u : 0u)))));
}

FUNCTION uint drop_highest_bit(uint x) {
    return x == 0u ? 0u : x - (1u << highest_bit(x));
}

FUNCTION uint rounded_inverse(uint segments) {
    return segments == 0u ? 0u : (65536u + (segments >> 1u)) / segments;
}

FUNCTION Edge make_edge(uint factor, uint odd) {
    Edge edge;
    uint h = (factor + 1u) >> 1u;
    h = h + (odd != 0u || h == 0x8000u ? 0x8000u : 0u);
    const uint floor_half = h >> 16u;
    const uint ceil_half = (h + 0xffffu) >> 16u;
    edge.odd = odd;
    edge.half_points = ceil_half;
    edge.points = 2u * ceil_half + 1u - odd;
    edge.fraction = h & 0xffffu;
    const uint from_odd = floor_half == 1u ? 0u : 2u * drop_highest_bit(floor_half - 1u) + 1u;
    const uint from_even = 2u * drop_highest_bit(floor_half) + 1u;
    edge.split = floor_half == ceil_half ? ceil_half + 1u : (odd != 0u ? from_odd : from_even);
    edge.inverse_floor = rounded_inverse(2u * floor_half - odd);
    edge.inverse_ceil = rounded_inverse(2u * ceil_half - odd);
    return edge;
}

/// Coordinate of point p in [0, points) of an edge. The second half mirrors the first exactly.
FUNCTION uint edge_coordinate(Edge edge, uint p) {
    const bool mirrored = p >= edge.half_points;
    const uint q = mirrored ? 2u * edge.half_points - p - edge.odd : p;
    const uint f = q - (q > edge.split ? 1u : 0u);
    const uint blended =
        (f * edge.inverse_floor * (65536u - edge.fraction) + q * edge.inverse_ceil * edge.fraction + 0x8000u) >> 16u;
    const uint place = q == edge.half_points ? 0x8000u : blended;
    return mirrored ? 65536u - place : place;
}

/// `a` where choice is 0, `b` where it is 1, `c` else.
FUNCTION Edge choose_edge(uint choice, Edge a, Edge b, Edge c) {
    Edge edge;
    edge.odd = choice == 0u ? a.odd : (choice == 1u ? b.odd : c.odd);
    edge.half_points = choice == 0u ? a.half_points : (choice == 1u ? b.half_points : c.half_points);
    edge.points = choice == 0u ? a.points : (choice == 1u ? b.points : c.points);
    edge.fraction = choice == 0u ? a.fraction : (choice == 1u ? b.fraction : c.fraction);
    edge.split = choice == 0u ? a.split : (choice == 1u ? b.split : c.split);
    edge.inverse_floor = choice == 0u ? a.inverse_floor : (choice == 1u ? b.inverse_floor : c.inverse_floor);
    edge.inverse_ceil = choice == 0u ? a.inverse_ceil : (choice == 1u ? b.inverse_ceil : c.inverse_ceil);
    return edge;
}

/// Three corners of a triangle in a row between an outer edge and the inside row. A corner is a position along the outer
/// edge, or along the inside row with ON_INSIDE added.
#define ON_INSIDE 256u

STRUCT(Triangle) {
    uint a;
    uint b;
    uint c;
};

FUNCTION Triangle make_triangle(uint a, uint b, uint c) {
    Triangle t;
    t.a = a;
    t.b = b;
    t.c = c;
    return t;
}

// The order of a transition row. Each half of an edge is walked in 31 steps; step m belongs to the node of a balanced
// binary tree of 31 nodes (numbered as a heap from 1) that comes m-th in order, and emits where the half has more
// nodes than that number. (The specification's table of final point positions is this tree, with 32 put in front.)

/// Heap number of step m in 1..31.
FUNCTION uint transition_node(uint m) {
    const uint lowest = m & (0u - m);
    return lowest == 16u ? 1u
         : (lowest == 8u ? 2u | (m >> 4u)
         : (lowest == 4u ? 4u | (m >> 3u)
         : (lowest == 2u ? 8u | (m >> 2u) : 16u | (m >> 1u))));
}

/// How many of the steps 1..m belong to nodes below `count` (1..32); 0 for count 0.
FUNCTION uint transition_rank(uint count, uint m) {
    const uint level = highest_bit(count);
    const uint complete = m >> (5u - level);                        // nodes of the levels that are full
    const uint partial = (((2u * m) >> (5u - level)) + 1u) >> 1u;   // nodes of the next level, if it were full
    const uint there = count - (1u << level);
    return count == 0u ? 0u : complete + (partial < there ? partial : there);
}

/// Triangle s of the row between an outer edge of `outer_segments` (>= 1) and an inside row of `inner_segments` (>= 0),
/// in all outer_segments + inner_segments triangles. The halves are those of the two factors: half_points - odd.
FUNCTION Triangle transition_triangle(uint s, uint outer_half, uint outer_odd, uint inner_half, uint inner_odd) {
    const uint outer_segments = 2u * outer_half + outer_odd;
    const uint inner_steps = inner_half == 0u ? 0u : inner_half - 1u;
    const uint inner_segments = 2u * inner_steps + inner_odd;
    const uint first_half = outer_half + inner_steps;
    const uint middle = outer_odd + inner_odd;
    if (s >= first_half && s < first_half + middle) {
        const uint o = outer_half;
        const uint i = ON_INSIDE + inner_steps;
        if (inner_odd == 0u) {
            return make_triangle(i, o, o + 1u);
        }
        return s == first_half ? make_triangle(i, o, i + 1u) : make_triangle(i + 1u, o, o + 1u);
    }
    // The second half is the first one read backwards.
    const bool backwards = s >= first_half;
    const uint t = backwards ? outer_segments + inner_segments - 1u - s : s;
    const uint lead = outer_half > 0u ? 1u : 0u;  // a half that has points begins with one outer triangle
    // The last step m whose first triangle is not after t; m = 0 is the leading outer triangle.
    uint m = 0u;
    for (uint bit = 16u; bit > 0u; bit = bit >> 1u) {
        const uint candidate = m + bit;
        const uint before = lead + transition_rank(inner_half, candidate - 1u)
                          + transition_rank(outer_half, candidate - 1u);
        m = before <= t ? candidate : m;
    }
    const uint steps = m == 0u ? 0u : m - 1u;
    const uint inner_before = transition_rank(inner_half, steps);
    const uint outer_before = m == 0u ? 0u : lead + transition_rank(outer_half, steps);
    const bool has_inner = m != 0u && transition_node(m) < inner_half;
    const bool is_inner = has_inner && t == inner_before + outer_before;
    const uint o = outer_before;
    const uint i = inner_before + (has_inner && !is_inner ? 1u : 0u);
    if (is_inner) {
        const uint outer_at = backwards ? outer_segments - o : o;
        const uint inner_at = ON_INSIDE + (backwards ? inner_segments - i - 1u : i);
        return make_triangle(inner_at, outer_at, inner_at + 1u);
    }
    const uint outer_at = backwards ? outer_segments - o - 1u : o;
    const uint inner_at = ON_INSIDE + (backwards ? inner_segments - i : i);
    return make_triangle(outer_at, outer_at + 1u, inner_at);
}

/// Triangle s of the regular row between a ring's row of points + 1 segments and the next one of `points` points (both
/// corners included); in all 2 * points triangles.
FUNCTION Triangle ring_triangle(uint s, uint points) {
    if (s == 0u || s == 2u * points - 1u) {
        const uint o = s == 0u ? 0u : points;
        const uint i = ON_INSIDE + (s == 0u ? 0u : points - 1u);
        return make_triangle(o, o + 1u, i);
    }
    const uint p = (s - 1u) >> 1u;
    const bool second = ((s - 1u) & 1u) == 1u;
    const uint o = 1u + p;
    const uint i = ON_INSIDE + p;
    if (p < (points >> 1u)) {
        return second ? make_triangle(o, o + 1u, i + 1u) : make_triangle(o, i + 1u, i);
    }
    return second ? make_triangle(i, o + 1u, i + 1u) : make_triangle(i, o, o + 1u);
}

KERNELS_END

#endif
