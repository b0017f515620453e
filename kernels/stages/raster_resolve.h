// Colours of samples -> picture: their mean in linear light, not multiplied by alpha any more. An item makes runs of
// pixels of a row of a tile, in the order in which samples lie.
#include "raster/srgb.h"

KERNELS_BEGIN

KERNEL4(raster_resolve, READ(0, uint, colours), READ(1, uint, texels), WRITE(2, uint, picture),
        UNIFORM(3, ResolveParams, params)) {
    const ResolveParams p = LOAD_UNIFORM(params);
    const uint begin = ITEM * p.item_pixels;
    const uint tile = begin >> 8u;
    const uint y = ((tile / p.tiles_x) << RASTER_TILE_LOG2) + ((begin >> 4u) & 15u);
    const uint left = (tile % p.tiles_x) << RASTER_TILE_LOG2;
    if (y >= p.height) {
        return;
    }
    const float share = p.samples == 4u ? 0.25f : 1.0f;
    for (uint column = begin & 15u; column < (begin & 15u) + p.item_pixels; column = column + RUN) {
        const uint first = left + column;
        const uint place = ((tile * p.samples) << 8u) + ((y & 15u) << 4u) + column;
        float red[RUN];
        float green[RUN];
        float blue[RUN];
        float alpha[RUN];
        uint codes[RUN];
        FOR_RUN(k) {
            red[k] = 0.0f;
            green[k] = 0.0f;
            blue[k] = 0.0f;
            alpha[k] = 0.0f;
        }
        for (uint s = 0u; s < p.samples; ++s) {
            FOR_RUN(k) {
                const uint code = colours[place + (s << 8u) + k];
                red[k] = red[k] + share * SRGB_DECODE(texels, code);
                green[k] = green[k] + share * SRGB_DECODE(texels, code >> 8u);
                blue[k] = blue[k] + share * SRGB_DECODE(texels, code >> 16u);
                alpha[k] = alpha[k] + share * (to_float(code >> 24u) * 0.0039215688593685627f);
            }
        }
        FOR_RUN(k) {
            const bool some = alpha[k] > 0.0f;
            const float r = some ? exact_reciprocal(some ? alpha[k] : 1.0f) : 0.0f;
            Colour mean;
            mean.red = red[k] * r;
            mean.green = green[k] * r;
            mean.blue = blue[k] * r;
            mean.alpha = alpha[k];
            codes[k] = PACK_COLOUR(texels, mean);
        }
        for (uint k = 0u; k < RUN; ++k) {
            if (first + k < p.width) {
                picture[y * p.width + first + k] = codes[k];
            }
        }
    }
}

KERNELS_END
