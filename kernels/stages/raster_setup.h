// Screen vertices -> records and bounds of triangles, runs of them. What needs clipping is left to raster_clip. The
// last run of a batch repeats its last triangle: `triangles` has room for whole runs. A triangle with an index beyond
// the draw's vertices is dropped here, and no later stage looks at it.
#include "raster/triangle_setup.h"

#define LOAD_SCREEN_POINT(to, index)                                                     \
    const uint to##_vertex = (index)-p.index_base;                                       \
    const bool to##_there = to##_vertex < p.vertex_count;                                \
    const uint to##_at = choose_bits(to##_there, to##_vertex, 0u) * SCREEN_VERTEX_WORDS; \
    ScreenPoint to;                                                                      \
    to.x = to_int(screen[to##_at]);                                                      \
    to.y = to_int(screen[to##_at + 1u]);                                                 \
    to.z = bits_float(screen[to##_at + 2u]);                                             \
    to.code = screen[to##_at + 3u] | choose_bits(to##_there, 0u, OUT_INVALID)

KERNELS_BEGIN

KERNEL4(raster_setup, READ(0, uint, screen), READ(1, uint, indices), WRITE(2, uint, triangles),
        UNIFORM(3, DrawParams, params)) {
    const DrawParams p = LOAD_UNIFORM(params);
    const uint begin = ITEM * p.entry_count;
    const uint end = begin + p.entry_count < p.triangle_count ? begin + p.entry_count : p.triangle_count;
    for (uint first_of_run = begin; first_of_run < end; first_of_run = first_of_run + RUN) {
        uint columns[RUN];
        uint rows[RUN];
        uint run[RUN * TRIANGLE_WORDS];
        FOR_RUN(k) {
            const uint i = p.index_at + (first_of_run + k < end ? first_of_run + k : end - 1u) * 3u;
            LOAD_SCREEN_POINT(a, indices[i]);
            LOAD_SCREEN_POINT(b, indices[i + 1u]);
            LOAD_SCREEN_POINT(c, indices[i + 2u]);
            const RasterTriangle t = make_raster_triangle(a, b, c, p.cull);
            const int left = smaller(a.x, smaller(b.x, c.x));
            const int right = larger(a.x, larger(b.x, c.x));
            const int top = smaller(a.y, smaller(b.y, c.y));
            const int bottom = larger(a.y, larger(b.y, c.y));
            const RasterBounds box = make_bounds(p, left, right, top, bottom);
            const uint any = (a.code | b.code) | c.code;
            const uint all = (a.code & b.code) & c.code;
            const bool gone = ((all & OUT_MASK) | (any & OUT_INVALID)) != 0u;
            const uint clipped = choose_bits(gone, 0u, any & OUT_CLIP);
            const uint empty = choose_bits(gone, 1u, choose_bits(t.drawn, 0u, 1u));
            columns[k] =
                choose_bits(clipped != 0u, BOUNDS_UNKNOWN, choose_bits(empty != 0u, BOUNDS_EMPTY, box.columns));
            rows[k] = choose_bits((clipped | empty) != 0u, BOUNDS_EMPTY, box.rows);
            const uint small = choose_bits(right - left <= SMALL_EXTENT, TRIANGLE_SMALL, 0u) &
                               choose_bits(bottom - top <= SMALL_EXTENT, TRIANGLE_SMALL, 0u) &
                               choose_bits(clipped != 0u, 0u, TRIANGLE_SMALL);
            run[k] = to_uint(t.x0);
            run[RUN + k] = to_uint(t.y0);
            run[2u * RUN + k] = (to_uint(t.dx1) & 0xffffu) | (to_uint(t.dy1) << 16u);
            run[3u * RUN + k] = (to_uint(t.dx2) & 0xffffu) | (to_uint(t.dy2) << 16u);
            run[4u * RUN + k] = float_bits(t.z0);
            run[5u * RUN + k] = float_bits(t.slope_x);
            run[6u * RUN + k] = float_bits(t.slope_y);
            run[7u * RUN + k] = t.flags | small;
        }
        for (uint k = 0u; k < RUN; ++k) {
            const uint i = first_of_run + k;
            triangles[i * BOUNDS_WORDS] = columns[k];
            triangles[i * BOUNDS_WORDS + 1u] = rows[k];
            if (columns[k] != BOUNDS_EMPTY) {
                for (uint word = 0u; word < TRIANGLE_WORDS; ++word) {
                    triangles[p.records_at + i * TRIANGLE_WORDS + word] = run[word * RUN + k];
                }
            }
        }
    }
}

KERNELS_END
