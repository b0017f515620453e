// Which tiles of a window a triangle may touch.
#ifndef TESSERA_RASTER_BINNING_H
#define TESSERA_RASTER_BINNING_H

#include "raster/raster_layout.h"

KERNELS_BEGIN

/// Tiles of the window, first to last (none where last < first).
STRUCT(TileSpan) {
    int first_x;
    int last_x;
    int first_y;
    int last_y;
};

FUNCTION int clamp_tile(int tile, int low, int high) {
    return tile < low ? low : (tile > high ? high : tile);
}

FUNCTION TileSpan tiles_of(BinParams p, uint columns, uint rows) {
    // A first tile behind the window and a last one before it give an empty span.
    TileSpan s;
    s.first_x = clamp_tile(to_int((columns & 0xffffu) >> p.tile_shift) - to_int(p.tile_x), 0, to_int(p.tiles_x));
    s.last_x = clamp_tile(to_int((columns >> 16u) >> p.tile_shift) - to_int(p.tile_x), -1, to_int(p.tiles_x) - 1);
    s.first_y = clamp_tile(to_int((rows & 0xffffu) >> p.tile_shift) - to_int(p.tile_y), 0, to_int(p.tiles_y));
    s.last_y = clamp_tile(to_int((rows >> 16u) >> p.tile_shift) - to_int(p.tile_y), -1, to_int(p.tiles_y) - 1);
    return s;
}

/// Items that have no block get `blocks`.
FUNCTION uint block_of(BinParams p, uint item) {
    const bool works = (item & ((1u << p.spread_log2) - 1u)) == 0u;
    return works ? item >> p.spread_log2 : p.blocks;
}

KERNELS_END

#endif
