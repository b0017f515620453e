// Texture sampling: addresses repeat, trilinear filtering, sRGB codes decoded before they are mixed.
#ifndef TESSERA_RASTER_TEXTURE_H
#define TESSERA_RASTER_TEXTURE_H

#include "raster/interpolation.h"

KERNELS_BEGIN

FUNCTION int floor_to_int(float x) {
    const int nearest = round_to_int(x);
    return nearest - to_int(choose_bits(to_float(nearest) > x, 1u, 0u));
}

/// log2 of a normal x > 0, at most 0.0081 off.
FUNCTION float rough_log2(float x) {
    const uint bits = float_bits(x);
    const float f = bits_float((bits & 0x007fffffu) | 0x3f800000u) - 1.0f;
    return to_float(to_int(bits >> 23u) - 127) + (f + 0.34375f * (f * (1.0f - f)));
}

/// The mip level for the change of texture coordinates from a pixel to its neighbours, as Vulkan defines it (isotropic,
/// the longer of the two steps), in [0, levels - 1].
FUNCTION float texture_level(DrawParams p, Weights across_step, Weights down_step, Corner a, Corner b, Corner c) {
    const float width = to_float(p.texture_width);
    const float height = to_float(p.texture_height);
    const float ux = flush_tiny(weigh(across_step, a.u, b.u, c.u) * width);
    const float vx = flush_tiny(weigh(across_step, a.v, b.v, c.v) * height);
    const float uy = flush_tiny(weigh(down_step, a.u, b.u, c.u) * width);
    const float vy = flush_tiny(weigh(down_step, a.v, b.v, c.v) * height);
    const float across = ux * ux + vx * vx;
    const float down = uy * uy + vy * vy;
    return at_most(0.5f * rough_log2(at_least(at_least(across, down), 1.0f)), to_float(p.texture_levels - 1u));
}

/// Four texels of a level, as offsets from its first, and their weights.
STRUCT(Taps) {
    uint a;
    uint b;
    uint c;
    uint d;
    float wa;
    float wb;
    float wc;
    float wd;
};

/// The extent of a level: halved once for each, and at least 1.
FUNCTION uint level_extent(uint extent, uint level) {
    const uint halved = extent >> level;
    return choose_bits(halved == 0u, 1u, halved);
}

/// The four texels around a place in rows of `width` texels, and how much of each: (fx, fy) of the step to (x1, y1).
FUNCTION Taps bilinear_taps(uint width, uint x0, uint y0, uint x1, uint y1, float fx, float fy) {
    Taps t;
    t.a = y0 * width + x0;
    t.b = y0 * width + x1;
    t.c = y1 * width + x0;
    t.d = y1 * width + x1;
    t.wa = (1.0f - fx) * (1.0f - fy);
    t.wb = fx * (1.0f - fy);
    t.wc = (1.0f - fx) * fy;
    t.wd = fx * fy;
    return t;
}

FUNCTION Taps make_taps(DrawParams p, uint level, float u, float v) {
    const uint w = level_extent(p.texture_width, level);
    const uint h = level_extent(p.texture_height, level);
    const float x = (u - to_float(floor_to_int(u))) * to_float(w) - 0.5f;
    const float y = (v - to_float(floor_to_int(v))) * to_float(h) - 0.5f;
    const int left = floor_to_int(x);
    const int top = floor_to_int(y);
    const float fx = x - to_float(left);
    const float fy = y - to_float(top);
    // u - floor(u) may round to 1, so `left` lies in [-1, w - 1] all the same.
    const uint x0 = choose_bits(left < 0, w - 1u, to_uint(left));
    const uint y0 = choose_bits(top < 0, h - 1u, to_uint(top));
    const uint x1 = choose_bits(left + 1 < to_int(w), to_uint(left + 1), 0u);
    const uint y1 = choose_bits(top + 1 < to_int(h), to_uint(top + 1), 0u);
    return bilinear_taps(w, x0, y0, x1, y1, fx, fy);
}

STRUCT(Colour) {
    float red;
    float green;
    float blue;
    float alpha;
};

KERNELS_END

// Texels are R, G, B, A from the lowest byte up.
#define SRGB_DECODE(texels, code) bits_float(texels[SRGB_DECODE_AT + ((code)&255u)])
#define ADD_TEXEL(colour, texels, at, weight)                                                       \
    {                                                                                               \
        const uint texel = texels[at];                                                              \
        colour.red = colour.red + (weight)*SRGB_DECODE(texels, texel);                              \
        colour.green = colour.green + (weight)*SRGB_DECODE(texels, texel >> 8u);                    \
        colour.blue = colour.blue + (weight)*SRGB_DECODE(texels, texel >> 16u);                     \
        colour.alpha = colour.alpha + (weight) * (to_float(texel >> 24u) * 0.0039215688593685627f); \
    }
#define ADD_LEVEL(colour, texels, p, level, u, v, share)           \
    {                                                              \
        const uint begin = texels[LEVELS_AT + (level)];            \
        const Taps taps = make_taps(p, level, u, v);               \
        ADD_TEXEL(colour, texels, begin + taps.a, (share)*taps.wa) \
        ADD_TEXEL(colour, texels, begin + taps.b, (share)*taps.wb) \
        ADD_TEXEL(colour, texels, begin + taps.c, (share)*taps.wc) \
        ADD_TEXEL(colour, texels, begin + taps.d, (share)*taps.wd) \
    }

#endif
