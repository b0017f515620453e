// Visible triangles -> colours of samples, for opaque materials. An item owns a pixel of a tile that has a list; a
// triangle that several samples of a pixel see is shaded once. Leaves VISIBLE_NONE behind for the next draw.
//
// To be included by a kernel that defines SHADE_NAME and SHADE_SURFACE(colour, p, back, x, y), a sequence of the steps
// of shading.h after SHADE_CORNERS that sets `colour`.
#include "raster/shading.h"
#include "raster/tile.h"

KERNELS_BEGIN

KERNEL7(SHADE_NAME, READ(0, uint, bins), WRITE(1, uint, visible), WRITE(2, uint, colours), READ(3, float, vertices),
        READ(4, uint, indices), READ(5, uint, texels), UNIFORM(6, DrawParams, params)) {
    const DrawParams p = LOAD_UNIFORM(params);
    const uint listed = ITEM >> 8u;
    if (listed >= p.tile_count) {
        return;
    }
    const uint tile = bins[LISTED_TILES_AT(p) + listed];
    const uint pixel = ITEM & 255u;
    const uint first = (tile << (8u + p.axis_log2)) + pixel;
    const uint x = ((p.tile_x + tile % p.tiles_x) << RASTER_TILE_LOG2) + (pixel & 15u);
    const uint y = ((p.tile_y + tile / p.tiles_x) << RASTER_TILE_LOG2) + (pixel >> 4u);
    uint shaded = VISIBLE_NONE;
    uint code = 0u;
    for (uint at = first; at < first + (256u << p.axis_log2); at = at + 256u) {
        const uint seen = visible[at];
        if (seen == VISIBLE_NONE) {
            continue;
        }
        if (seen != shaded) {
            const uint triangle = seen & ~VISIBLE_BACK;
            Colour colour;
            SHADE_CORNERS(p, triangle, x, y)
            SHADE_SURFACE(colour, p, (seen & VISIBLE_BACK) != 0u, x, y)
            if (p.wires != 0u) {
                SHADE_STEPS(p, x, y)
                colour = wires_over(colour, beside_edges(weights, across, down));
            }
            colour.alpha = 1.0f;
            code = PACK_COLOUR(texels, colour);
            shaded = seen;
        }
        visible[at] = VISIBLE_NONE;
        colours[at] = code;
    }
}

KERNELS_END
