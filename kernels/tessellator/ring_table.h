// Inner points and triangles of triangle patches, read instead of worked out. Which points a ring has, and which
// triangles lie between two rings, depends on nothing but how many rings lie inside; so all patterns with rings are
// made of the innermost rings of two, the largest with an odd and with an even inside factor. A table holds these two.
// Kernels bind it beside the records; src/tessellate/ring_table.cpp makes it.
#ifndef TESSERA_TESSELLATOR_RING_TABLE_H
#define TESSERA_TESSELLATOR_RING_TABLE_H

#include "tessellator/triangle.h"

KERNELS_BEGIN

// Words of a table: inner points of the pattern with 64 points on an edge of its inside factor, of that with 65, then
// the inner triangles of both, three words each: corners counted from the first inner point on. Runs may begin and end
// outside.
#define RING_TABLE_MARGIN 16u
#define RING_POINTS_64 2883u
#define RING_POINTS_65 2977u
#define RING_TRIANGLES_64 5581u
#define RING_TRIANGLES_65 5766u
#define RING_POINTS_AT_64 RING_TABLE_MARGIN
#define RING_POINTS_AT_65 (RING_POINTS_AT_64 + RING_POINTS_64 + RING_TABLE_MARGIN)
#define RING_TRIANGLES_AT_64 (RING_POINTS_AT_65 + RING_POINTS_65 + RING_TABLE_MARGIN)
#define RING_TRIANGLES_AT_65 (RING_TRIANGLES_AT_64 + 3u * RING_TRIANGLES_64 + RING_TABLE_MARGIN)
#define RING_STEPS_AT (RING_TRIANGLES_AT_65 + 3u * RING_TRIANGLES_65 + RING_TABLE_MARGIN)
// Last the steps (row.h) of every pair of halves, outer ones of 0 to 32 and inner ones of 1 to 32, four in a word.
#define RING_STEPS 33264u
#define RING_TABLE_WORDS (RING_STEPS_AT + RING_STEPS / 4u + RING_TABLE_MARGIN)

// A point's word: its ring; in bits 8 to 15 its place on the ring's side, counted on the whole edge from the nearer
// end; whether that is the far one; and its side in the highest bits.
#define RING_POINT_FAR 0x10000u
#define RING_POINT_SIDE1 0x1000000u
#define RING_POINT_SIDE2 0x2000000u

/// Where the inner rings of a patch begin in a table.
STRUCT(RingPlace) {
    uint points;     // word of its first inner point
    uint shift;      // subtracted from the words of points: as many rings and places as the larger pattern has before
    uint triangles;  // word of the first triangle that is not of row 1
    uint base;       // added to a triangle's words
};

FUNCTION RingPlace ring_place(TrianglePatch p) {
    RingPlace place;
    const uint n = p.inside.points;
    const bool odd = (n & 1u) == 1u;
    const uint largest = odd ? 65u : 64u;
    const uint before = (largest - n) >> 1u;
    const uint points_before = 3u * before * (largest - 2u - before);
    const uint triangles_before = 6u * (before * largest + 2u - (1u + before) * (2u + before));
    place.points = (odd ? RING_POINTS_AT_65 : RING_POINTS_AT_64) + points_before;
    place.shift = before * 0x101u;
    place.triangles = (odd ? RING_TRIANGLES_AT_65 : RING_TRIANGLES_AT_64) + 3u * triangles_before;
    place.base = p.outer_points - points_before;
    return place;
}

/// Where the steps of a pair of halves begin: after those of smaller outer halves, and of smaller inner ones beside it.
FUNCTION uint ring_steps_before(uint outer_half, uint inner_half) {
    const uint smaller = inner_half - 1u;
    return 496u * outer_half + 16u * outer_half * (outer_half - 1u) + smaller * outer_half +
           ((smaller * (smaller - 1u)) >> 1u);
}

/// The number of the step that makes a triangle of row 1; within the table for what is no triangle too.
FUNCTION uint ring_step(TrianglePatch p, OuterPlace place) {
    const uint at = transition_at(place.row, place.s);
    return ring_steps_before(place.row.outer_half, p.inside.half_points - p.inside.odd) + (at < 64u ? at : 0u);
}

/// Its word, and the step from this word.
FUNCTION uint ring_step_word(uint number) {
    return RING_STEPS_AT + (number >> 2u);
}
FUNCTION uint ring_step_of(uint word, uint number) {
    return (word >> (8u * (number & 3u))) & 0xffu;
}

/// An inner point from its word, the shift subtracted.
FUNCTION DomainPoint inner_point(Edge inside, uint word) {
    const uint across = (edge_place(inside, word & 0xffu) * 0xaaaau + 0x8000u) >> 16u;
    const uint nearer = edge_place(inside, (word >> 8u) & 0xffu);
    const uint along = ((word & RING_POINT_FAR) != 0u ? 65536u - nearer : nearer) - ((across + 1u) >> 1u);
    const uint rest = 65536u - along - across;
    return make_domain_point(word < RING_POINT_SIDE1 ? across : along,
                             word < RING_POINT_SIDE1 ? along : (word < RING_POINT_SIDE2 ? across : rest));
}

/// Point i of the outer ring.
FUNCTION DomainPoint outer_point(TrianglePatch p, uint i) {
    const uint start1 = p.edge0.points - 1u;
    const uint start2 = start1 + p.edge1.points - 1u;
    const bool first = i < start1;
    const bool last = i >= start2;
    const Edge edge = choose_edge(last, choose_edge(first, p.edge1, p.edge0), p.edge2);
    const uint k = i - (first ? 0u : (last ? start2 : start1));
    // Side 1 runs up along its edge, the others down.
    const uint along = edge_coordinate(edge, first || last ? edge.points - 1u - k : k);
    return make_domain_point(first ? 0u : along, first ? along : (last ? 65536u - along : 0u));
}

KERNELS_END

#endif
