// Visible triangles -> colours of samples. An item owns a pixel; a triangle is shaded once per pixel, at its middle.
// Leaves VISIBLE_NONE behind for the next draw.
#include "raster/shading.h"
#include "raster/tile.h"

KERNELS_BEGIN

KERNEL7(raster_shade, READ(0, uint, bins), WRITE(1, uint, visible), WRITE(2, uint, colours), READ(3, float, vertices),
        READ(4, uint, indices), READ(5, uint, texels), UNIFORM(6, DrawParams, params)) {
    const DrawParams p = LOAD_UNIFORM(params);
    const uint tile = ITEM >> 8u;
    if (tile >= p.tiles_x * p.tiles_y || bins[tile] == bins[tile + 1u]) {
        return;
    }
    const uint pixel = ITEM & 255u;
    const uint place = ((tile << p.axis_log2) << 8u) + pixel;
    const uint samples = 1u << p.axis_log2;
    uint shaded = VISIBLE_NONE;
    uint code = 0u;
    for (uint s = 0u; s < samples; ++s) {
        const uint at = place + (s << 8u);
        const uint seen = visible[at];
        if (seen == VISIBLE_NONE) {
            continue;
        }
        visible[at] = VISIBLE_NONE;
        if (seen != shaded) {
            const uint x = ((p.tile_x + tile % p.tiles_x) << RASTER_TILE_LOG2) + (pixel & 15u);
            const uint y = ((p.tile_y + tile / p.tiles_x) << RASTER_TILE_LOG2) + (pixel >> 4u);
            Colour colour;
            bool dropped;
            SHADE(colour, dropped, p, (seen & ~VISIBLE_BACK), (seen & VISIBLE_BACK) != 0u, x, y)
            code = dropped ? 0u : PACK_COLOUR(texels, colour);  // none is: masks are drawn by raster_forward
            shaded = seen;
        }
        colours[at] = code;
    }
}

KERNELS_END
