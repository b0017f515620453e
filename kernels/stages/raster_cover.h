// Lists of tiles -> the nearest triangle of each sample. Most triangles are smaller than a pixel: what they need is
// in their record, and only rows and columns of samples within their box are looked at.
#include "raster/tile.h"

// What a triangle shows of samples that it covers (1, else 0) at depth z, where it is nearer: of sample k of a run that
// begins at `at`, kept in arrays until the run is stored; and of a sample by itself.
#define KEEP_IN_RUN(k, at, covered, z, seen)                                                                  \
    const uint there = depths[(at) + k];                                                                      \
    const uint seen_there = visible[(at) + k];                                                                \
    const uint hit = ((covered)&choose_bits(z >= 0.0f, 1u, 0u)) & choose_bits(z < bits_float(there), 1u, 0u); \
    nearest[k] = choose_bits(hit != 0u, float_bits(z), there);                                                \
    nearest_seen[k] = choose_bits(hit != 0u, seen, seen_there);
#define STORE_SAMPLES(at)                    \
    for (uint k = 0u; k < RUN; ++k) {        \
        depths[(at) + k] = nearest[k];       \
    }                                        \
    for (uint k = 0u; k < RUN; ++k) {        \
        visible[(at) + k] = nearest_seen[k]; \
    }
#define KEEP_SAMPLE(place, z, seen)                   \
    if (z >= 0.0f && z < bits_float(depths[place])) { \
        depths[place] = float_bits(z);                \
        visible[place] = seen;                        \
    }

KERNELS_BEGIN

KERNEL5(raster_cover, READ(0, uint, bins), READ(1, uint, triangles), WRITE(2, uint, depths), WRITE(3, uint, visible),
        UNIFORM(4, DrawParams, params)) {
    const DrawParams p = LOAD_UNIFORM(params);
    const uint listed = listed_tile_of(p, ITEM);
    if (listed >= p.tile_count) {
        return;
    }
    const TilePart part = tile_part(p, ITEM, bins[LISTED_TILES_AT(p) + listed]);
    const uint first = p.list_at + bins[part.tile] + p.first_entry;
    const uint end = p.list_at + bins[part.tile + 1u];
    const uint last = end > first + p.entry_count ? first + p.entry_count : end;
    const uint unit_log2 = RASTER_SUBPIXELS_LOG2 - p.axis_log2;
    // Sub-pixels from the middle of the image of sample column and row 0.
    const int origin_x = (1 << (unit_log2 - 1u)) - to_int(p.columns << (unit_log2 - 1u));
    const int origin_y = (1 << (unit_log2 - 1u)) - to_int(p.rows << (unit_log2 - 1u));
    const int axis_mask = (1 << p.axis_log2) - 1;
    for (uint n = first; n < last; ++n) {
        const uint triangle = bins[n];
        const uint soon = bins[n + 8u < last ? n + 8u : n];  // other processors have written what is to come
        PREFETCH(triangles, soon * BOUNDS_WORDS);
        PREFETCH(triangles, p.records_at + soon * TRIANGLE_WORDS);
        const uint columns = triangles[triangle * BOUNDS_WORDS];
        const uint rows = triangles[triangle * BOUNDS_WORDS + 1u];
        const int first_row = larger(to_int(rows & 0xffffu), part.first_row);
        const int last_row = smaller(to_int(rows >> 16u), part.last_row);
        const int first_column = larger(to_int(columns & 0xffffu), part.first_column);
        const int last_column = smaller(to_int(columns >> 16u), part.last_column);
        const uint at = p.records_at + triangle * TRIANGLE_WORDS;
        const uint flags = triangles[at + 7u];
        uint covered_few = flags >> TRIANGLE_COVERED_SHIFT;
        if (covered_few != 0u) {
            const RasterTriangle t = LOAD_SMALL_TRIANGLE(triangles, at, flags);
            const uint seen = triangle | ((flags & TRIANGLE_BACK) != 0u ? VISIBLE_BACK : 0u);
            const int left = to_int((columns & 0xffffu) - ((flags >> TRIANGLE_LEFT_SHIFT) & TRIANGLE_LEFT_MASK));
            const int top = to_int(rows & 0xffffu);
            while (covered_few != 0u) {
                const uint rest = covered_few & (covered_few - 1u);
                // The number of the lowest bit, from the exponent of its value.
                const uint number = (float_bits(to_float(covered_few - rest)) >> 23u) - 127u;
                covered_few = rest;
                const int row = top + to_int(number >> 1u);
                const int in_pixel = column_in_pixel(p, row);
                const int x = ((left - in_pixel + axis_mask) >> p.axis_log2) + to_int(number & 1u);
                const int column = (x << p.axis_log2) + in_pixel;
                if (row >= first_row && row <= last_row && column >= first_column && column <= last_column) {
                    const int px = origin_x + (column << unit_log2) - t.x0;
                    const int py = origin_y + (row << unit_log2) - t.y0;
                    const float z = t.z0 + (t.slope_x * to_float(px) + t.slope_y * to_float(py));
                    const uint place = sample_index(p, part.tile, x, row);
                    KEEP_SAMPLE(place, z, seen)
                }
            }
        } else if ((flags & TRIANGLE_SMALL) != 0u) {
            const RasterTriangle t = LOAD_SMALL_TRIANGLE(triangles, at, flags);
            const int least2 = edge_least(t.dx1, t.dy1);
            const int least1 = edge_least(-t.dx2, -t.dy2);
            const int least0 = edge_least(t.dx2 - t.dx1, t.dy2 - t.dy1);
            const int area = t.dx1 * t.dy2 - t.dy1 * t.dx2;
            const uint seen = triangle | ((flags & TRIANGLE_BACK) != 0u ? VISIBLE_BACK : 0u);
            for (int row = first_row; row <= last_row; ++row) {
                const int in_pixel = column_in_pixel(p, row);
                const int first_x = (first_column - in_pixel + axis_mask) >> p.axis_log2;
                const int last_x = (last_column - in_pixel) >> p.axis_log2;
                const int py = origin_y + (row << unit_log2) - t.y0;
                if (RUN > 1u && last_x - first_x >= 2) {
                    // The whole row of the tile at once; what lies beyond the box is not covered.
                    const uint row_at = sample_index(p, part.tile, 0, row);
                    const int row_x = origin_x + ((part.first_column + in_pixel) << unit_log2) - t.x0;
                    const int step = 1 << RASTER_SUBPIXELS_LOG2;
                    for (uint from = 0u; from < RASTER_TILE; from = from + RUN) {
                        uint nearest[RUN];
                        uint nearest_seen[RUN];
                        FOR_RUN(k) {
                            const int px = row_x + to_int(from + k) * step;
                            const int e2 = t.dx1 * py - t.dy1 * px;
                            const int e1 = t.dy2 * px - t.dx2 * py;
                            const int e0 = area - e1 - e2;
                            const float z = t.z0 + (t.slope_x * to_float(px) + t.slope_y * to_float(py));
                            const uint covered =
                                (choose_bits(e2 >= least2, 1u, 0u) & choose_bits(e1 >= least1, 1u, 0u)) &
                                choose_bits(e0 >= least0, 1u, 0u);
                            KEEP_IN_RUN(k, row_at + from, covered, z, seen)
                        }
                        STORE_SAMPLES(row_at + from)
                    }
                    continue;
                }
                for (int x = first_x; x <= last_x; ++x) {
                    const int px = origin_x + (((x << p.axis_log2) + in_pixel) << unit_log2) - t.x0;
                    const int e2 = t.dx1 * py - t.dy1 * px;
                    const int e1 = t.dy2 * px - t.dx2 * py;
                    const int e0 = area - e1 - e2;
                    if (e2 >= least2 && e1 >= least1 && e0 >= least0) {
                        const float z = t.z0 + (t.slope_x * to_float(px) + t.slope_y * to_float(py));
                        const uint place = sample_index(p, part.tile, x, row);
                        KEEP_SAMPLE(place, z, seen)
                    }
                }
            }
        } else {
            SampleBox box;
            box.left = origin_x + (first_column << unit_log2);
            box.right = origin_x + (last_column << unit_log2);
            box.top = origin_y + (first_row << unit_log2);
            box.bottom = origin_y + (last_row << unit_log2);
            const uint polygon = p.polygons_at + triangle * POLYGON_WORDS;
            const uint corners = triangles[polygon];
            for (uint corner = 2u; corner < corners; ++corner) {
                const RasterTriangle t = make_raster_triangle(LOAD_POLYGON_CORNER(triangles, polygon, 0u),
                                                              LOAD_POLYGON_CORNER(triangles, polygon, corner - 1u),
                                                              LOAD_POLYGON_CORNER(triangles, polygon, corner), p.cull);
                if (!t.drawn || misses(t, box)) {
                    continue;
                }
                const uint seen = triangle | ((t.flags & TRIANGLE_BACK) != 0u ? VISIBLE_BACK : 0u);
                for (int row = first_row; row <= last_row; ++row) {
                    const int in_pixel = column_in_pixel(p, row);
                    const int first_x = (first_column - in_pixel + axis_mask) >> p.axis_log2;
                    const int last_x = (last_column - in_pixel) >> p.axis_log2;
                    const int sy = origin_y + (row << unit_log2);
                    if (RUN > 1u) {  // as above
                        const uint row_at = sample_index(p, part.tile, 0, row);
                        const int row_x = origin_x + ((part.first_column + in_pixel) << unit_log2);
                        const int step = 1 << RASTER_SUBPIXELS_LOG2;
                        for (uint from = 0u; from < RASTER_TILE; from = from + RUN) {
                            uint nearest[RUN];
                            uint nearest_seen[RUN];
                            FOR_RUN(k) {
                                const int sx = row_x + to_int(from + k) * step;
                                const float z = depth_at(t, sx, sy);
                                KEEP_IN_RUN(k, row_at + from, coverage(t, sx, sy), z, seen)
                            }
                            STORE_SAMPLES(row_at + from)
                        }
                        continue;
                    }
                    for (int x = first_x; x <= last_x; ++x) {
                        const int sx = origin_x + (((x << p.axis_log2) + in_pixel) << unit_log2);
                        if (covers(t, sx, sy)) {
                            const float z = depth_at(t, sx, sy);
                            const uint place = sample_index(p, part.tile, x, row);
                            KEEP_SAMPLE(place, z, seen)
                        }
                    }
                }
            }
        }
    }
}

KERNELS_END
