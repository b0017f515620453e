// Bounds -> the lists of tiles, each in the order of the triangles. Uses up the counts.
#include "raster/binning.h"

KERNELS_BEGIN

KERNEL4(raster_fill, READ(0, uint, triangles), WRITE(1, uint, counts), WRITE(2, uint, bins),
        UNIFORM(3, BinParams, params)) {
    const BinParams p = LOAD_UNIFORM(params);
    const uint block = block_of(p, ITEM);
    if (block >= p.blocks) {
        return;
    }
    const uint row = block * (p.tiles_x * p.tiles_y);
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
                const uint tile = to_uint(y) * p.tiles_x + to_uint(x);
                const uint place = counts[row + tile];
                counts[row + tile] = place + 1u;
                bins[p.list_at + bins[tile] + place] = triangle;
            }
        }
    }
}

KERNELS_END
