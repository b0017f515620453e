// A row of triangles between two neighbouring rings of points: which corners each triangle has, and in which order.
// Source: D3D11.3 functional specification, 11.7.
#ifndef TESSERA_TESSELLATOR_ROW_H
#define TESSERA_TESSELLATOR_ROW_H

#include "tessellator/edge.h"

KERNELS_BEGIN

/// Three corners of a triangle in a row between an outer edge and the inside row. A corner is a position along the
/// outer edge, or along the inside row with ON_INSIDE added.
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
    const uint depth = highest_bit(m & (0u - m));  // from the leaves, which are the odd steps
    return (16u >> depth) | (m >> (depth + 1u));
}

/// How many of the steps 1..m belong to nodes below `count` (1..32); 0 for count 0.
FUNCTION uint transition_rank(uint count, uint m) {
    const uint level = highest_bit(count);
    const uint complete = m >> (5u - level);                       // nodes of the levels that are full
    const uint partial = (((2u * m) >> (5u - level)) + 1u) >> 1u;  // nodes of the next level, if it were full
    const uint there = count - (1u << level);
    return count == 0u ? 0u : complete + (partial < there ? partial : there);
}

/// A step of the search for the last step of a half whose first triangle is not after t; `lead` triangles come first.
FUNCTION uint find_step(uint m, uint bit, uint lead, uint inner_half, uint outer_half, uint t) {
    const uint before = lead + transition_rank(inner_half, m + bit - 1u) + transition_rank(outer_half, m + bit - 1u);
    return before <= t ? m + bit : m;
}

FUNCTION Triangle choose_triangle(bool choice, Triangle a, Triangle b) {
    return make_triangle(choice ? a.a : b.a, choice ? a.b : b.b, choice ? a.c : b.c);
}

/// What the row between two edges is made of. The halves are those of the two factors: half_points - odd.
STRUCT(Transition) {
    uint outer_segments;  // >= 1
    uint inner_segments;  // >= 0
    uint outer_half;
    uint outer_odd;
    uint inner_steps;
    uint inner_odd;
};

FUNCTION Transition make_transition(uint outer_half, uint outer_odd, uint inner_half, uint inner_odd) {
    Transition r;
    r.outer_half = outer_half;
    r.outer_odd = outer_odd;
    r.inner_steps = inner_half == 0u ? 0u : inner_half - 1u;
    r.inner_odd = inner_odd;
    r.outer_segments = 2u * outer_half + outer_odd;
    r.inner_segments = 2u * r.inner_steps + inner_odd;
    return r;
}

/// Triangle s of a row is in the second half, which is the first one read backwards, or between the two.
FUNCTION bool transition_is_backwards(Transition r, uint s) {
    return s >= r.outer_half + r.inner_steps;
}

/// The place in its half of triangle s of a row.
FUNCTION uint transition_at(Transition r, uint s) {
    return transition_is_backwards(r, s) ? r.outer_segments + r.inner_segments - 1u - s : s;
}

/// A triangle of the first half: so many segments of the outer edge are before it, and it is one of the inside row.
#define TRANSITION_INNER 128u

FUNCTION uint transition_step(uint t, uint outer_half, uint inner_half) {
    const uint lead = outer_half > 0u ? 1u : 0u;  // a half that has points begins with one outer triangle
    // m = 0 is the leading outer triangle.
    uint m = 0u;
    FOR_BITS(bit, m = find_step(m, bit, lead, inner_half, outer_half, t))
    const uint steps = m == 0u ? 0u : m - 1u;
    const uint inner_before = transition_rank(inner_half, steps);
    const uint outer_before = m == 0u ? 0u : lead + transition_rank(outer_half, steps);
    const bool has_inner = m != 0u && transition_node(m) < inner_half;
    const bool is_inner = has_inner && t == inner_before + outer_before;
    return outer_before | (is_inner ? TRANSITION_INNER : 0u);
}

/// Triangle s of a row from the step that is at its place.
FUNCTION Triangle stepped_triangle(Transition r, uint s, uint step) {
    const uint first_half = r.outer_half + r.inner_steps;
    // Between the halves: the odd segments of either edge.
    const bool in_middle = s >= first_half && s < first_half + r.outer_odd + r.inner_odd;
    const bool middle_inner = r.inner_odd != 0u && s == first_half;
    const uint middle_at = ON_INSIDE + r.inner_steps + (r.inner_odd != 0u && !middle_inner ? 1u : 0u);
    const Triangle middle = make_triangle(middle_at, r.outer_half, middle_inner ? middle_at + 1u : r.outer_half + 1u);
    const bool backwards = transition_is_backwards(r, s);
    const bool is_inner = step >= TRANSITION_INNER;
    const uint o = is_inner ? step - TRANSITION_INNER : step;
    const uint i = transition_at(r, s) - o;
    const uint outer_at = backwards ? r.outer_segments - o - (is_inner ? 0u : 1u) : o;
    const uint inner_at = ON_INSIDE + (backwards ? r.inner_segments - i - (is_inner ? 1u : 0u) : i);
    const Triangle stepped = make_triangle(is_inner ? inner_at : outer_at, is_inner ? outer_at : outer_at + 1u,
                                           is_inner ? inner_at + 1u : inner_at);
    return choose_triangle(in_middle, middle, stepped);
}

/// Triangle s of the row between an outer edge and an inside row, in all outer_segments + inner_segments triangles.
FUNCTION Triangle transition_triangle(uint s, uint outer_half, uint outer_odd, uint inner_half, uint inner_odd) {
    const Transition r = make_transition(outer_half, outer_odd, inner_half, inner_odd);
    return stepped_triangle(r, s, transition_step(transition_at(r, s), outer_half, inner_half));
}

/// Triangle s of the regular row between a ring's row of points + 1 segments and the next one of `points` points (both
/// corners included); in all 2 * points triangles.
FUNCTION Triangle ring_triangle(uint s, uint points) {
    const bool at_start = s == 0u;
    const bool at_end = s == 2u * points - 1u;
    const uint end_outer = at_start ? 0u : points;
    const Triangle end = make_triangle(end_outer, end_outer + 1u, ON_INSIDE + (at_start ? 0u : points - 1u));
    const uint cell = (s - 1u) >> 1u;
    const bool second = ((s - 1u) & 1u) == 1u;
    const bool first_half = cell < (points >> 1u);
    const uint o = 1u + cell;
    const uint i = ON_INSIDE + cell;
    const Triangle between = make_triangle(first_half ? o : i, second ? o + 1u : (first_half ? i + 1u : o),
                                           second ? i + 1u : (first_half ? i : o + 1u));
    return choose_triangle(at_start || at_end, end, between);
}

/// A closed ring of points: `points` of them (0 stands for a single one) from index `start` on. A folded ring is a row
/// of points/2 + 1 that is walked forth and back.
STRUCT(Ring) {
    uint start;
    uint points;
    uint folded;
};

FUNCTION Ring make_ring(uint start, uint points) {
    Ring ring;
    ring.start = start;
    ring.points = points;
    ring.folded = 0u;
    return ring;
}

/// Point index of the position `offset + at` on a ring; positions wrap around once.
FUNCTION uint ring_point(Ring ring, uint offset, uint at) {
    const uint sum = offset + at;
    const uint wrapped = sum >= ring.points && ring.points > 0u ? sum - ring.points : sum;
    const uint unfolded = ring.points == 0u ? 0u : wrapped;
    return ring.start + (ring.folded != 0u && 2u * unfolded > ring.points ? ring.points - unfolded : unfolded);
}

FUNCTION uint place_corner(uint corner, Ring outer, uint outer_offset, Ring inner, uint inner_offset) {
    return corner < ON_INSIDE ? ring_point(outer, outer_offset, corner)
                              : ring_point(inner, inner_offset, corner - ON_INSIDE);
}

/// A triangle of a row -> point indices. The side's row begins at the given offsets of the two rings.
FUNCTION Triangle place_row(Triangle row, Ring outer, uint outer_offset, Ring inner, uint inner_offset) {
    return make_triangle(place_corner(row.a, outer, outer_offset, inner, inner_offset),
                         place_corner(row.b, outer, outer_offset, inner, inner_offset),
                         place_corner(row.c, outer, outer_offset, inner, inner_offset));
}

KERNELS_END

#endif
