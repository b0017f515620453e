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
    bool exists;
    uint tile;  // of the window
    int first_column;
    int last_column;
    int first_row;
    int last_row;
};

FUNCTION TilePart tile_part(DrawParams p, uint item) {
    const uint tiles = p.tiles_x * p.tiles_y;
    const uint worker = item >> p.spread_log2;
    const uint part = worker & ((1u << p.parts_log2) - 1u);
    const uint tile = worker >> p.parts_log2;
    const uint height_log2 = RASTER_TILE_LOG2 + p.axis_log2 - p.parts_log2;
    TilePart t;
    t.exists = tile < tiles && (item & ((1u << p.spread_log2) - 1u)) == 0u;
    t.tile = tile;
    const uint safe = t.exists ? tile : 0u;
    const uint x = p.tile_x + safe % p.tiles_x;
    const uint y = p.tile_y + safe / p.tiles_x;
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

KERNELS_END

#endif
