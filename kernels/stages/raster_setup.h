// Screen vertices -> records and bounds of triangles. What needs clipping is left to raster_clip.
#include "raster/triangle_setup.h"

#define LOAD_SCREEN_POINT(to, vertex)                             \
    ScreenPoint to;                                               \
    to.x = to_int(screen[(vertex)*SCREEN_VERTEX_WORDS]);          \
    to.y = to_int(screen[(vertex)*SCREEN_VERTEX_WORDS + 1u]);     \
    to.z = bits_float(screen[(vertex)*SCREEN_VERTEX_WORDS + 2u]); \
    to.code = screen[(vertex)*SCREEN_VERTEX_WORDS + 3u]

KERNELS_BEGIN

KERNEL5(raster_setup, READ(0, uint, screen), READ(1, uint, indices), WRITE(2, uint, records), WRITE(3, uint, bounds),
        UNIFORM(4, DrawParams, params)) {
    const DrawParams p = LOAD_UNIFORM(params);
    const uint i = ITEM;
    if (i >= p.triangle_count) {
        return;
    }
    LOAD_SCREEN_POINT(a, indices[i * 3u]);
    LOAD_SCREEN_POINT(b, indices[i * 3u + 1u]);
    LOAD_SCREEN_POINT(c, indices[i * 3u + 2u]);
    const RasterTriangle t = make_raster_triangle(a, b, c, p.cull);
    const int left = smaller(a.x, smaller(b.x, c.x));
    const int right = larger(a.x, larger(b.x, c.x));
    const int top = smaller(a.y, smaller(b.y, c.y));
    const int bottom = larger(a.y, larger(b.y, c.y));
    const RasterBounds box = make_bounds(p, left, right, top, bottom);
    const uint any = (a.code | b.code) | c.code;
    const uint all = (a.code & b.code) & c.code;
    const bool gone = (all & OUT_MASK) != 0u || (any & OUT_INVALID) != 0u;
    const bool clipped = !gone && (any & OUT_CLIP) != 0u;
    const bool empty = gone || !t.drawn;
    bounds[i * BOUNDS_WORDS] = clipped ? BOUNDS_UNKNOWN : (empty ? BOUNDS_EMPTY : box.columns);
    bounds[i * BOUNDS_WORDS + 1u] = clipped || empty ? BOUNDS_EMPTY : box.rows;
    const bool small = !clipped && right - left <= SMALL_EXTENT && bottom - top <= SMALL_EXTENT;
    const uint at = i * TRIANGLE_WORDS;
    records[at] = to_uint(t.x0);
    records[at + 1u] = to_uint(t.y0);
    records[at + 2u] = (to_uint(t.dx1) & 0xffffu) | (to_uint(t.dy1) << 16u);
    records[at + 3u] = (to_uint(t.dx2) & 0xffffu) | (to_uint(t.dy2) << 16u);
    records[at + 4u] = float_bits(t.z0);
    records[at + 5u] = float_bits(t.slope_x);
    records[at + 6u] = float_bits(t.slope_y);
    records[at + 7u] = t.flags | (small ? TRIANGLE_SMALL : 0u);
}

KERNELS_END
