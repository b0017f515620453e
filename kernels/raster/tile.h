// The part of a tile that one item owns.
#ifndef TESSERA_RASTER_TILE_H
#define TESSERA_RASTER_TILE_H

#include "raster/triangle_setup.h"

// What `visible` holds: triangle of the draw, and whether its back is seen; nothing new since it was last shaded.
#define VISIBLE_NONE 0xffffffffu
#define VISIBLE_BACK 0x80000000u

KERNELS_BEGIN

/// Samples of the image from (first_column, first_row) to (last_column, last_row).
STRUCT(TilePart) {
    uint tile;  // of the window
    int first_column;
    int last_column;
    int first_row;
    int last_row;
};

/// The place among the tiles with lists of the one that an item has a part of; none from tile_count on.
FUNCTION uint listed_tile_of(DrawParams p, uint item) {
    const bool works = (item & ((1u << p.spread_log2) - 1u)) == 0u;
    return works ? item >> (p.spread_log2 + p.parts_log2) : p.tile_count;
}

FUNCTION TilePart tile_part(DrawParams p, uint item, uint tile) {
    const uint part = (item >> p.spread_log2) & ((1u << p.parts_log2) - 1u);
    const uint height_log2 = RASTER_TILE_LOG2 + p.axis_log2 - p.parts_log2;
    TilePart t;
    t.tile = tile;
    const uint x = p.tile_x + tile % p.tiles_x;
    const uint y = p.tile_y + tile / p.tiles_x;
    t.first_column = to_int(x << (RASTER_TILE_LOG2 + p.axis_log2));
    t.last_column = t.first_column + (1 << (RASTER_TILE_LOG2 + p.axis_log2)) - 1;
    t.first_row = to_int((y << (RASTER_TILE_LOG2 + p.axis_log2)) + (part << height_log2));
    t.last_row = t.first_row + (1 << height_log2) - 1;
    return t;
}

/// The sample column within its pixel of the sample in a row.
FUNCTION int column_in_pixel(DrawParams p, int row) {
    const uint of_pixel = to_uint(row) & ((1u << p.axis_log2) - 1u);
    return to_int((p.column_of_row >> (2u * of_pixel)) & 3u);
}

/// The place of the sample of a row in the pixel column `x` of the image.
FUNCTION uint sample_index(DrawParams p, uint tile, int x, int row) {
    const uint of_pixel = to_uint(row) & ((1u << p.axis_log2) - 1u);
    const uint y = to_uint(row) >> p.axis_log2;
    return (((tile << p.axis_log2) + of_pixel) << 8u) + ((y & 15u) << 4u) + (to_uint(x) & 15u);
}

FUNCTION ScreenPoint make_screen_point(uint x, uint y, uint z) {
    ScreenPoint s;
    s.x = to_int(x);
    s.y = to_int(y);
    s.z = bits_float(z);
    s.code = 0u;
    return s;
}

/// The triangle of a record whose corners 1 and 2 are packed.
FUNCTION RasterTriangle unpack_triangle(uint x0, uint y0, uint d1, uint d2, uint z0, uint slope_x, uint slope_y,
                                        uint flags) {
    RasterTriangle t;
    t.x0 = to_int(x0);
    t.y0 = to_int(y0);
    t.dx1 = to_int(d1 << 16u) >> 16;
    t.dy1 = to_int(d1) >> 16;
    t.dx2 = to_int(d2 << 16u) >> 16;
    t.dy2 = to_int(d2) >> 16;
    t.z0 = bits_float(z0);
    t.slope_x = bits_float(slope_x);
    t.slope_y = bits_float(slope_y);
    t.z_min = -1e30f;
    t.z_max = 1e30f;
    t.flags = flags;
    t.drawn = true;
    return t;
}

KERNELS_END

/// Where `bins` numbers the tiles that have lists.
#define LISTED_TILES_AT(p) ((p).tiles_x * (p).tiles_y + 1u)

#define LOAD_SMALL_TRIANGLE(triangles, at, flags)                                                    \
    unpack_triangle(triangles[at], triangles[(at) + 1u], triangles[(at) + 2u], triangles[(at) + 3u], \
                    triangles[(at) + 4u], triangles[(at) + 5u], triangles[(at) + 6u], flags)
#define LOAD_POLYGON_CORNER(triangles, at, corner)                                                \
    make_screen_point(triangles[(at) + 1u + 3u * (corner)], triangles[(at) + 2u + 3u * (corner)], \
                      triangles[(at) + 3u + 3u * (corner)])

#endif
