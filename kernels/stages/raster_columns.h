// Exclusive sums down each column of counts[block][tile], and the totals of tiles.
#include "raster/binning.h"

KERNELS_BEGIN

KERNEL3(raster_columns, WRITE(0, uint, counts), WRITE(1, uint, totals), UNIFORM(2, BinParams, params)) {
    const BinParams p = LOAD_UNIFORM(params);
    const uint tiles = p.tiles_x * p.tiles_y;
    const uint tile = ITEM;
    if (tile >= tiles) {
        return;
    }
    uint sum = 0u;
    for (uint block = 0u; block < p.blocks; ++block) {
        const uint at = block * tiles + tile;
        const uint here = counts[at];
        counts[at] = sum;
        sum = sum + here;
    }
    totals[tile] = sum;
}

KERNELS_END
