// Triangles in fixed point: orientation, coverage by the top-left rule, depth.
//
// A sample p is inside an edge from a to b of a triangle of positive area where
//     E = (b - a).x * (p - a).y - (b - a).y * (p - a).x
// is positive, or zero and the edge is a top or a left one. Coordinates are integers under 2^22, so that E may need 45
// bits; it is known exactly all the same: as a float, with an error under 2^23, and modulo 2^32.
#ifndef TESSERA_RASTER_TRIANGLE_SETUP_H
#define TESSERA_RASTER_TRIANGLE_SETUP_H

#include "raster/screen.h"

KERNELS_BEGIN

/// The sign of ax * by - ay * bx: -1, 0 or 1, for integers under 2^22.
FUNCTION int cross_sign(int ax, int ay, int bx, int by) {
    const float estimate = to_float(ax) * to_float(by) - to_float(ay) * to_float(bx);
    const int low = to_int(to_uint(ax) * to_uint(by) - to_uint(ay) * to_uint(bx));
    const int near_zero = low > 0 ? 1 : (low < 0 ? -1 : 0);
    return estimate > 1073741824.0f ? 1 : (estimate < -1073741824.0f ? -1 : near_zero);
}

/// ax * by - ay * bx as a float, exact where it is under 2^24; never zero unless it is.
FUNCTION float cross_float(int ax, int ay, int bx, int by) {
    const float estimate = to_float(ax) * to_float(by) - to_float(ay) * to_float(bx);
    const int low = to_int(to_uint(ax) * to_uint(by) - to_uint(ay) * to_uint(bx));
    const bool small = estimate < 1073741824.0f && estimate > -1073741824.0f && low < 16777216 && low > -16777216;
    return small ? to_float(small ? low : 0) : estimate;
}

/// 0 where a sample on the edge belongs to the triangle (top or left, y down), else 1: what E must at least be.
FUNCTION int edge_least(int dx, int dy) {
    return dy < 0 || (dy == 0 && dx > 0) ? 0 : 1;
}

STRUCT(RasterTriangle) {
    int x0;
    int y0;
    int dx1;  // to corner 1
    int dy1;
    int dx2;  // to corner 2
    int dy2;
    float z0;
    float slope_x;  // of depth, per sub-pixel
    float slope_y;
    float z_min;
    float z_max;
    uint flags;
    bool drawn;  // has an area, and shows the side that is drawn
};

/// Turns the triangle so that its area is positive, which is clockwise on the screen: front faces, which are
/// counter-clockwise, swap two corners. Depth slopes come from the places on the screen.
FUNCTION RasterTriangle make_raster_triangle(ScreenPoint a, ScreenPoint b, ScreenPoint c, uint cull) {
    const int sign = cross_sign(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
    const bool front = sign < 0;
    RasterTriangle t;
    t.x0 = a.x;
    t.y0 = a.y;
    t.dx1 = (front ? c.x : b.x) - a.x;
    t.dy1 = (front ? c.y : b.y) - a.y;
    t.dx2 = (front ? b.x : c.x) - a.x;
    t.dy2 = (front ? b.y : c.y) - a.y;
    const float dz1 = (front ? c.z : b.z) - a.z;
    const float dz2 = (front ? b.z : c.z) - a.z;
    const float area = cross_float(t.dx1, t.dy1, t.dx2, t.dy2);
    const float r = exact_reciprocal(area > 0.0f ? area : 1.0f);
    t.z0 = a.z;
    t.slope_x = (dz1 * to_float(t.dy2) - dz2 * to_float(t.dy1)) * r;
    t.slope_y = (dz2 * to_float(t.dx1) - dz1 * to_float(t.dx2)) * r;
    const float low = b.z < c.z ? b.z : c.z;
    const float high = b.z < c.z ? c.z : b.z;
    t.z_min = a.z < low ? a.z : low;
    t.z_max = a.z > high ? a.z : high;
    t.flags = front ? 0u : TRIANGLE_BACK;
    t.drawn = sign < 0 || (sign > 0 && cull == 0u);
    return t;
}

/// 1 where the sample at (x, y), sub-pixels from the middle of the image, is covered, else 0.
FUNCTION uint coverage(RasterTriangle t, int x, int y) {
    const int px = x - t.x0;
    const int py = y - t.y0;
    const int ex = t.dx2 - t.dx1;
    const int ey = t.dy2 - t.dy1;
    return (choose_bits(cross_sign(t.dx1, t.dy1, px, py) >= edge_least(t.dx1, t.dy1), 1u, 0u) &
            choose_bits(cross_sign(ex, ey, px - t.dx1, py - t.dy1) >= edge_least(ex, ey), 1u, 0u)) &
           choose_bits(cross_sign(-t.dx2, -t.dy2, px, py) >= edge_least(-t.dx2, -t.dy2), 1u, 0u);
}

FUNCTION bool covers(RasterTriangle t, int x, int y) {
    return coverage(t, x, y) != 0u;
}

STRUCT(SampleBox) {
    int left;
    int right;
    int top;
    int bottom;
};

/// 1 where an edge through (x, y) has all of the box outside.
FUNCTION uint edge_excludes(int dx, int dy, int x, int y, SampleBox box) {
    const int innermost_x = to_int(choose_bits(dy > 0, to_uint(box.left), to_uint(box.right)));
    const int innermost_y = to_int(choose_bits(dx > 0, to_uint(box.bottom), to_uint(box.top)));
    return choose_bits(cross_sign(dx, dy, innermost_x - x, innermost_y - y) >= edge_least(dx, dy), 0u, 1u);
}

/// Whether the triangle covers no sample of a box, as far as each edge tells alone.
FUNCTION bool misses(RasterTriangle t, SampleBox box) {
    const uint first = edge_excludes(t.dx1, t.dy1, t.x0, t.y0, box);
    const uint second = edge_excludes(t.dx2 - t.dx1, t.dy2 - t.dy1, t.x0 + t.dx1, t.y0 + t.dy1, box);
    return ((first | second) | edge_excludes(-t.dx2, -t.dy2, t.x0, t.y0, box)) != 0u;
}

/// Depth at a covered sample. Kept between the corners' depths, for slopes of slivers are inexact.
FUNCTION float depth_at(RasterTriangle t, int x, int y) {
    const float z = t.z0 + (t.slope_x * to_float(x - t.x0) + t.slope_y * to_float(y - t.y0));
    return z < t.z_min ? t.z_min : (z > t.z_max ? t.z_max : z);
}

STRUCT(RasterBounds) {
    uint columns;
    uint rows;
};

FUNCTION int smaller(int a, int b) {
    return a < b ? a : b;
}
FUNCTION int larger(int a, int b) {
    return a > b ? a : b;
}

/// Samples lie at unit / 2 + unit * i from the left of the image: the first of them at or beyond `low`, the last
/// at or before `high`, as first | last << 16; BOUNDS_EMPTY where the image has none.
FUNCTION uint sample_range(int low, int high, int half_size, uint count, uint unit_log2) {
    const int unit = 1 << unit_log2;
    const int first = larger((low + half_size - (unit >> 1) + unit - 1) >> unit_log2, 0);
    const int last = smaller((high + half_size - (unit >> 1)) >> unit_log2, to_int(count) - 1);
    return first > last ? BOUNDS_EMPTY : (to_uint(first) | (to_uint(last) << 16u));
}

/// Bounds of the box from (left, top) to (right, bottom) in sub-pixels from the middle of the image.
FUNCTION RasterBounds make_bounds(DrawParams p, int left, int right, int top, int bottom) {
    const uint unit_log2 = RASTER_SUBPIXELS_LOG2 - p.axis_log2;
    RasterBounds b;
    b.columns = sample_range(left, right, to_int(p.columns << (unit_log2 - 1u)), p.columns, unit_log2);
    b.rows = sample_range(top, bottom, to_int(p.rows << (unit_log2 - 1u)), p.rows, unit_log2);
    if (b.columns == BOUNDS_EMPTY || b.rows == BOUNDS_EMPTY) {
        b.columns = BOUNDS_EMPTY;
        b.rows = BOUNDS_EMPTY;
    }
    return b;
}

KERNELS_END

#endif
