// Screen vertices -> records and bounds of triangles, runs of them. What needs clipping is left to raster_clip. The
// last run of a batch repeats its last triangle: `triangles` has room for whole runs. A triangle with an index beyond
// the draw's vertices is dropped here, and no later stage looks at it.
#include "raster/triangle_setup.h"

// Signed indices, of which compilers know that they do not wrap around: CPUs gather by 32 bits then.
#define SCREEN_WORD(vertex, word) screen[to_int(vertex) * 4 + (word)]
#define LOAD_SCREEN_POINT(to, index)                                  \
    const uint to##_named = (index)-p.index_base;                     \
    const bool to##_there = to##_named < p.vertex_count;              \
    const uint to##_vertex = choose_bits(to##_there, to##_named, 0u); \
    ScreenPoint to;                                                   \
    to.x = to_int(SCREEN_WORD(to##_vertex, 0));                       \
    to.y = to_int(SCREEN_WORD(to##_vertex, 1));                       \
    to.z = bits_float(SCREEN_WORD(to##_vertex, 2));                   \
    to.code = SCREEN_WORD(to##_vertex, 3) | choose_bits(to##_there, 0u, OUT_INVALID)

#define FEW_WORDS 13u

KERNELS_BEGIN

KERNEL4(raster_setup, READ(0, uint, screen), READ(1, uint, indices), WRITE(2, uint, triangles),
        UNIFORM(3, DrawParams, params)) {
    const DrawParams p = LOAD_UNIFORM(params);
    const uint begin = ITEM * p.entry_count;
    const uint end = begin + p.entry_count < p.triangle_count ? begin + p.entry_count : p.triangle_count;
    const uint axis_mask = (1u << p.axis_log2) - 1u;
    const uint few_columns = 2u << p.axis_log2;  // of which a row has up to two samples
    const uint unit_log2 = RASTER_SUBPIXELS_LOG2 - p.axis_log2;
    // Sub-pixels from the middle of the image of sample column and row 0.
    const uint origin_x = (1u << (unit_log2 - 1u)) - (p.columns << (unit_log2 - 1u));
    const uint origin_y = (1u << (unit_log2 - 1u)) - (p.rows << (unit_log2 - 1u));
    for (uint first_of_run = begin; first_of_run < end; first_of_run = first_of_run + RUN) {
        uint columns[RUN];
        uint rows[RUN];
        uint run[RUN * TRIANGLE_WORDS];
        uint few[RUN * FEW_WORDS];
        uint most_rows = 0u;
        FOR_RUN(k) {
            const int i = to_int(p.index_at) + smaller(to_int(first_of_run) + to_int(k), to_int(end) - 1) * 3;
            LOAD_SCREEN_POINT(a, indices[i]);
            LOAD_SCREEN_POINT(b, indices[i + 1]);
            LOAD_SCREEN_POINT(c, indices[i + 2]);
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
            const uint small = choose_bits(right - left <= SMALL_EXTENT, TRIANGLE_SMALL, 0u) &
                               choose_bits(bottom - top <= SMALL_EXTENT, TRIANGLE_SMALL, 0u) &
                               choose_bits(clipped != 0u, 0u, TRIANGLE_SMALL);
            const uint in_box = choose_bits(empty != 0u, BOUNDS_EMPTY, box.columns);
            const uint polygon = clipped | (choose_bits(in_box == BOUNDS_EMPTY, 0u, TRIANGLE_SMALL) & ~small);
            columns[k] = choose_bits(polygon != 0u, BOUNDS_UNKNOWN, in_box);
            rows[k] = choose_bits((polygon | empty) != 0u, BOUNDS_EMPTY, box.rows);
            run[k] = to_uint(t.x0);
            run[RUN + k] = to_uint(t.y0);
            run[2u * RUN + k] = (to_uint(t.dx1) & 0xffffu) | (to_uint(t.dy1) << 16u);
            run[3u * RUN + k] = (to_uint(t.dx2) & 0xffffu) | (to_uint(t.dy2) << 16u);
            run[4u * RUN + k] = float_bits(t.z0);
            run[5u * RUN + k] = float_bits(t.slope_x);
            run[6u * RUN + k] = float_bits(t.slope_y);
            run[7u * RUN + k] = (t.flags | small) | choose_bits(clipped != 0u, TRIANGLE_CLIPPED, 0u);
            // Edge functions from which is taken what they must at least be: their sign bits tell of samples outside.
            const uint width = (columns[k] >> 16u) - (columns[k] & 0xffffu);
            const uint height = (rows[k] >> 16u) - (rows[k] & 0xffffu);
            const bool is_few = (choose_bits(width < few_columns, 1u, 0u) & choose_bits(height < FEW_ROWS, small, 0u) &
                                 choose_bits(columns[k] == BOUNDS_EMPTY, 0u, 1u)) != 0u;
            const uint least2 = to_uint(edge_least(t.dx1, t.dy1));
            const uint least1 = to_uint(edge_least(-t.dx2, -t.dy2));
            const uint least0 = to_uint(edge_least(t.dx2 - t.dx1, t.dy2 - t.dy1));
            few[k] = choose_bits(is_few, height + 1u, 0u);
            few[RUN + k] = to_uint(t.dx1);
            few[2u * RUN + k] = to_uint(t.dy1);
            few[3u * RUN + k] = to_uint(t.dx2);
            few[4u * RUN + k] = to_uint(t.dy2);
            few[5u * RUN + k] = least1;
            few[6u * RUN + k] = least2;
            few[7u * RUN + k] =
                (to_uint(t.dx1) * to_uint(t.dy2) - to_uint(t.dy1) * to_uint(t.dx2)) - ((least0 + least1) + least2);
            few[8u * RUN + k] = 0u;         // bits of covered samples,
            few[9u * RUN + k] = 0xffffu;    // and the first
            few[10u * RUN + k] = 0u;        // and last column,
            few[11u * RUN + k] = FEW_ROWS;  // and the first
            few[12u * RUN + k] = 0u;        // and last row with any, from the first row of the box
        }
        for (uint k = 0u; k < RUN; ++k) {
            most_rows = most_rows > few[k] ? most_rows : few[k];
        }
        for (uint j = 0u; j < most_rows; ++j) {
            FOR_RUN(k) {
                const uint row = (rows[k] & 0xffffu) + j;
                const uint in_pixel = (p.column_of_row >> (2u * (row & axis_mask))) & 3u;
                const uint column =
                    ((((columns[k] & 0xffffu) + axis_mask - in_pixel) >> p.axis_log2) << p.axis_log2) + in_pixel;
                const uint px = origin_x + (column << unit_log2) - run[k];
                const uint py = origin_y + (row << unit_log2) - run[RUN + k];
                const uint e2 = few[RUN + k] * py - few[2u * RUN + k] * px - few[6u * RUN + k];
                const uint e1 = few[4u * RUN + k] * px - few[3u * RUN + k] * py - few[5u * RUN + k];
                const uint e0 = few[7u * RUN + k] - e1 - e2;
                const uint next_e2 = e2 - few[2u * RUN + k] * 256u;
                const uint next_e1 = e1 + few[4u * RUN + k] * 256u;
                const uint next_e0 = few[7u * RUN + k] - next_e1 - next_e2;
                const uint next = column + axis_mask + 1u;
                const uint last = columns[k] >> 16u;
                const uint beyond = few[k] - 1u - j;
                const uint hit = (~((((e2 | e1) | e0) | (last - column)) | beyond)) >> 31u;
                const uint next_hit = (~((((next_e2 | next_e1) | next_e0) | (last - next)) | beyond)) >> 31u;
                const uint first_seen = choose_bits(hit != 0u, column, choose_bits(next_hit != 0u, next, 0xffffu));
                const uint last_seen = choose_bits(next_hit != 0u, next, choose_bits(hit != 0u, column, 0u));
                const uint first_row = choose_bits((hit | next_hit) != 0u, j, FEW_ROWS);
                const uint last_row = choose_bits((hit | next_hit) != 0u, j, 0u);
                few[8u * RUN + k] = few[8u * RUN + k] | ((hit | (next_hit << 1u)) << (2u * j));
                few[9u * RUN + k] = few[9u * RUN + k] < first_seen ? few[9u * RUN + k] : first_seen;
                few[10u * RUN + k] = few[10u * RUN + k] > last_seen ? few[10u * RUN + k] : last_seen;
                few[11u * RUN + k] = few[11u * RUN + k] < first_row ? few[11u * RUN + k] : first_row;
                few[12u * RUN + k] = few[12u * RUN + k] > last_row ? few[12u * RUN + k] : last_row;
            }
        }
        FOR_RUN(k) {
            const bool is_few = few[k] != 0u;
            const bool none = few[8u * RUN + k] == 0u;
            const uint left = columns[k] & 0xffffu;
            const uint top = rows[k] & 0xffffu;
            const uint few_columns_seen = few[9u * RUN + k] | (few[10u * RUN + k] << 16u);
            const uint few_rows_seen = (top + few[11u * RUN + k]) | ((top + few[12u * RUN + k]) << 16u);
            const uint few_flags = ((few[9u * RUN + k] - left) << TRIANGLE_LEFT_SHIFT) |
                                   ((few[8u * RUN + k] >> (2u * (few[11u * RUN + k] & 7u))) << TRIANGLE_COVERED_SHIFT);
            columns[k] = choose_bits(is_few, choose_bits(none, BOUNDS_EMPTY, few_columns_seen), columns[k]);
            rows[k] = choose_bits(is_few, choose_bits(none, BOUNDS_EMPTY, few_rows_seen), rows[k]);
            run[7u * RUN + k] = run[7u * RUN + k] | choose_bits(is_few, few_flags, 0u);
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
