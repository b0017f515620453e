// Colours of samples -> picture: their mean in linear light, not multiplied by alpha any more. Rows of the window.
#include "raster/srgb.h"

KERNELS_BEGIN

KERNEL4(raster_resolve, READ(0, uint, colours), READ(1, uint, texels), WRITE(2, uint, picture),
        UNIFORM(3, ResolveParams, params)) {
    const ResolveParams p = LOAD_UNIFORM(params);
    const uint item = ITEM;
    if (item >= p.width * p.height) {
        return;
    }
    const uint x = item % p.width;
    const uint y = item / p.width;
    const uint tile = (y >> RASTER_TILE_LOG2) * p.tiles_x + (x >> RASTER_TILE_LOG2);
    const uint place = ((tile * p.samples) << 8u) + ((y & 15u) << 4u) + (x & 15u);
    Colour mean;
    mean.red = 0.0f;
    mean.green = 0.0f;
    mean.blue = 0.0f;
    mean.alpha = 0.0f;
    const float share = p.samples == 4u ? 0.25f : 1.0f;
    for (uint s = 0u; s < p.samples; ++s) {
        const uint code = colours[place + (s << 8u)];
        mean.red = mean.red + share * SRGB_DECODE(texels, code);
        mean.green = mean.green + share * SRGB_DECODE(texels, code >> 8u);
        mean.blue = mean.blue + share * SRGB_DECODE(texels, code >> 16u);
        mean.alpha = mean.alpha + share * (to_float(code >> 24u) * 0.0039215688593685627f);
    }
    const float r = mean.alpha > 0.0f ? exact_reciprocal(mean.alpha) : 0.0f;
    mean.red = mean.red * r;
    mean.green = mean.green * r;
    mean.blue = mean.blue * r;
    picture[item] = PACK_COLOUR(texels, mean);
}

KERNELS_END
