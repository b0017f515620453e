// Bounds -> triangles per block and tile. An item counts a block of consecutive triangles in its own row.
#include "raster/binning.h"

KERNELS_BEGIN

KERNEL3(raster_count, READ(0, uint, triangles), WRITE(1, uint, counts), UNIFORM(2, BinParams, params)) {
    const BinParams p = LOAD_UNIFORM(params);
    const uint block = block_of(p, ITEM);
    if (block >= p.blocks) {
        return;
    }
    const uint tiles = p.tiles_x * p.tiles_y;
    const uint row = block * tiles;
    for (uint tile = 0u; tile < tiles; ++tile) {
        counts[row + tile] = 0u;
    }
    const uint end = (block + 1u) * p.block;
    const uint last = end < p.triangle_count ? end : p.triangle_count;
    for (uint i = block * p.block; i < last; ++i) {
        const uint triangle = p.first_triangle + i;
        const uint columns = triangles[triangle * BOUNDS_WORDS];
        if (columns == BOUNDS_EMPTY) {
            continue;
        }
        const TileSpan s = tiles_of(p, columns, triangles[triangle * BOUNDS_WORDS + 1u]);
        for (int y = s.first_y; y <= s.last_y; ++y) {
            for (int x = s.first_x; x <= s.last_x; ++x) {
                const uint at = row + to_uint(y) * p.tiles_x + to_uint(x);
                counts[at] = counts[at] + 1u;
            }
        }
    }
}

KERNELS_END
