// Masked and blended materials: triangles of a tile in order, each shaded where it passes the depth test. What a mask
// drops leaves depth alone; what blends is drawn over what is there and leaves depth alone too.
#include "raster/shading.h"
#include "raster/tile.h"

// Included once more for metallic-roughness materials, with steps of their own.
#ifndef FORWARD_NAME
#define FORWARD_NAME raster_forward
#define FORWARD_SHADE SHADE
#endif

KERNELS_BEGIN

KERNEL9(FORWARD_NAME, READ(0, uint, bins), READ(1, uint, triangles), READ(2, float, vertices), READ(3, uint, indices),
        READ(4, float, attributes), READ(5, uint, texels), WRITE(6, uint, depths), WRITE(7, uint, colours),
        UNIFORM(8, DrawParams, params)) {
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
    const int origin_x = (1 << (unit_log2 - 1u)) - to_int(p.columns << (unit_log2 - 1u));
    const int origin_y = (1 << (unit_log2 - 1u)) - to_int(p.rows << (unit_log2 - 1u));
    for (uint n = first; n < last; ++n) {
        const uint triangle = bins[n];
        const uint columns = triangles[triangle * BOUNDS_WORDS];
        const uint rows = triangles[triangle * BOUNDS_WORDS + 1u];
        const int first_y = larger(to_int(rows & 0xffffu), part.first_row) >> p.axis_log2;
        const int last_y = smaller(to_int(rows >> 16u), part.last_row) >> p.axis_log2;
        const int first_x = larger(to_int(columns & 0xffffu), part.first_column) >> p.axis_log2;
        const int last_x = smaller(to_int(columns >> 16u), part.last_column) >> p.axis_log2;
        const uint at = p.records_at + triangle * TRIANGLE_WORDS;
        const uint flags = triangles[at + 7u];
        const bool small = (flags & TRIANGLE_SMALL) != 0u;
        const uint polygon = p.polygons_at + (small ? 0u : triangle) * POLYGON_WORDS;
        const uint corners = small ? 3u : triangles[polygon];
        for (uint corner = 2u; corner < corners; ++corner) {
            RasterTriangle t;
            if (small) {
                t = LOAD_SMALL_TRIANGLE(triangles, at, flags);
            } else {
                t = make_raster_triangle(LOAD_POLYGON_CORNER(triangles, polygon, 0u),
                                         LOAD_POLYGON_CORNER(triangles, polygon, corner - 1u),
                                         LOAD_POLYGON_CORNER(triangles, polygon, corner), p.cull);
            }
            if (!t.drawn) {
                continue;
            }
            for (int y = first_y; y <= last_y; ++y) {
                for (int x = first_x; x <= last_x; ++x) {
                    bool shaded = false;
                    bool dropped = false;
                    Colour colour;
                    colour.red = 0.0f;
                    colour.green = 0.0f;
                    colour.blue = 0.0f;
                    colour.alpha = 0.0f;
                    for (int s = 0; s < (1 << p.axis_log2); ++s) {
                        const int row = (y << p.axis_log2) + s;
                        const int column = (x << p.axis_log2) + column_in_pixel(p, row);
                        const int sx = origin_x + (column << unit_log2);
                        const int sy = origin_y + (row << unit_log2);
                        if (!covers(t, sx, sy)) {
                            continue;
                        }
                        const float z = depth_at(t, sx, sy);
                        const uint place = sample_index(p, part.tile, x, row);
                        if (!(z >= 0.0f && z < bits_float(depths[place]))) {
                            continue;
                        }
                        if (!shaded) {
                            FORWARD_SHADE(colour, dropped, p, triangle, (t.flags & TRIANGLE_BACK) != 0u, to_uint(x),
                                          to_uint(y))
                            shaded = true;
                        }
                        if (dropped) {
                            continue;
                        }
                        Colour mixed = colour;
                        if (p.keeps_alpha != 0u) {
                            const uint behind = colours[place];
                            const float through = 1.0f - colour.alpha;
                            mixed.red = colour.red + through * SRGB_DECODE(texels, behind);
                            mixed.green = colour.green + through * SRGB_DECODE(texels, behind >> 8u);
                            mixed.blue = colour.blue + through * SRGB_DECODE(texels, behind >> 16u);
                            mixed.alpha = colour.alpha + through * (to_float(behind >> 24u) * 0.0039215688593685627f);
                        } else {
                            depths[place] = float_bits(z);
                        }
                        colours[place] = PACK_COLOUR(texels, mixed);
                    }
                }
            }
        }
    }
}

KERNELS_END

#undef FORWARD_NAME
#undef FORWARD_SHADE
