// One edge of a domain: how many points a factor puts on it, and where. Unsigned 32-bit arithmetic only.
// Source: D3D11.3 functional specification, 11.7.
#ifndef TESSERA_TESSELLATOR_EDGE_H
#define TESSERA_TESSELLATOR_EDGE_H

#include "layout.h"

KERNELS_BEGIN

/// What a resolved factor says about its edge. Coordinates are 16.16: 65536 is the far end.
STRUCT(Edge) {
    uint odd;          // 1: an odd number of segments
    uint half_points;  // points up to the middle, rounded up
    uint points;       // points on the edge, both ends included
    uint split;        // the point that the higher pattern has and the lower one lacks
    // What a step of the lower pattern, and of both, is worth in the blend of both: 65536 / segments, rounded, times
    // the share of the pattern in 65536ths. Products of positions wrap where those of the specification do.
    uint lower_step;
    uint both_steps;
};

/// Index of the highest set bit; 0 for 0. Values up to 6 bits.
FUNCTION uint highest_bit(uint x) {
    return (x >= 2u ? 1u : 0u) + (x >= 4u ? 1u : 0u) + (x >= 8u ? 1u : 0u) + (x >= 16u ? 1u : 0u) +
           (x >= 32u ? 1u : 0u);
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
    const uint fraction = h & 0xffffu;
    const uint from_odd = floor_half == 1u ? 0u : 2u * drop_highest_bit(floor_half - 1u) + 1u;
    const uint from_even = 2u * drop_highest_bit(floor_half) + 1u;
    edge.split = floor_half == ceil_half ? ceil_half + 1u : (odd != 0u ? from_odd : from_even);
    edge.lower_step = rounded_inverse(2u * floor_half - odd) * (65536u - fraction);
    edge.both_steps = edge.lower_step + rounded_inverse(2u * ceil_half - odd) * fraction;
    return edge;
}

/// Coordinate of point q in [0, half_points] of an edge. Past the split the lower pattern is one step behind.
FUNCTION uint edge_place(Edge edge, uint q) {
    const uint rounding = q > edge.split ? 0x8000u - edge.lower_step : 0x8000u;
    const uint blended = (q * edge.both_steps + rounding) >> 16u;
    return q == edge.half_points ? 0x8000u : blended;
}

/// Coordinate of point p in [0, points) of an edge. The second half mirrors the first exactly.
FUNCTION uint edge_coordinate(Edge edge, uint p) {
    const bool mirrored = p >= edge.half_points;
    const uint place = edge_place(edge, mirrored ? 2u * edge.half_points - p - edge.odd : p);
    return mirrored ? 65536u - place : place;
}

/// Coordinate of point p of `level` even segments. Symmetric: p and level - p give c and 65536 - c.
FUNCTION uint even_coordinate(uint p, uint level) {
    const bool mirrored = 2u * p > level;
    const uint q = mirrored ? level - p : p;
    const uint place = (q * 65536u + (level >> 1u)) / level;
    return mirrored ? 65536u - place : place;
}

FUNCTION Edge choose_edge(bool second, Edge a, Edge b) {
    Edge edge;
    edge.odd = second ? b.odd : a.odd;
    edge.half_points = second ? b.half_points : a.half_points;
    edge.points = second ? b.points : a.points;
    edge.split = second ? b.split : a.split;
    edge.lower_step = second ? b.lower_step : a.lower_step;
    edge.both_steps = second ? b.both_steps : a.both_steps;
    return edge;
}

/// A place in the domain, 16.16. For triangles w = 65536 - u - v.
STRUCT(DomainPoint) {
    uint u;
    uint v;
};

FUNCTION DomainPoint make_domain_point(uint u, uint v) {
    DomainPoint point;
    point.u = u;
    point.v = v;
    return point;
}

KERNELS_END

#endif
