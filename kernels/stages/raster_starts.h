// Totals of tiles and of their groups -> where each tile's list begins; one word more for where the last one ends.
#include "raster/binning.h"

KERNELS_BEGIN

KERNEL4(raster_starts, READ(0, uint, totals), READ(1, uint, sums), WRITE(2, uint, bins),
        UNIFORM(3, BinParams, params)) {
    const BinParams p = LOAD_UNIFORM(params);
    const uint tiles = p.tiles_x * p.tiles_y;
    const uint group = ITEM;
    const uint first = group * RASTER_SCAN_GROUP;
    if (first >= tiles) {
        return;
    }
    const uint last = tiles - first < RASTER_SCAN_GROUP ? tiles : first + RASTER_SCAN_GROUP;
    uint start = 0u;
    for (uint i = 0u; i < group; ++i) {
        start = start + sums[i];
    }
    for (uint i = first; i < last; ++i) {
        bins[i] = start;
        start = start + totals[i];
    }
    if (last == tiles) {
        bins[tiles] = start;
    }
}

KERNELS_END
