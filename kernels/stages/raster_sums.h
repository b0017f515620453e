// Totals of tiles -> totals of groups of RASTER_SCAN_GROUP tiles.
#include "raster/binning.h"

KERNELS_BEGIN

KERNEL3(raster_sums, READ(0, uint, totals), WRITE(1, uint, sums), UNIFORM(2, BinParams, params)) {
    const BinParams p = LOAD_UNIFORM(params);
    const uint tiles = p.tiles_x * p.tiles_y;
    const uint first = ITEM * RASTER_SCAN_GROUP;
    if (first >= tiles) {
        return;
    }
    const uint last = tiles - first < RASTER_SCAN_GROUP ? tiles : first + RASTER_SCAN_GROUP;
    uint sum = 0u;
    for (uint i = first; i < last; ++i) {
        sum = sum + totals[i];
    }
    sums[ITEM] = sum;
}

KERNELS_END
