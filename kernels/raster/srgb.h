// Linear light to 8-bit codes.
#ifndef TESSERA_RASTER_SRGB_H
#define TESSERA_RASTER_SRGB_H

#include "raster/texture.h"

KERNELS_BEGIN

// The curve is linear between 104 places: eight per octave from 2^-13 to 1, the upper bits of the float. It is at most
// 0.02 codes off.
FUNCTION float encodable(float x) {
    return at_most(at_least(x, 1.220703125e-4f), 0.99999994f);
}
FUNCTION uint encode_entry(float x) {
    return (float_bits(x) - 0x39000000u) >> 20u;
}
FUNCTION float encode_step(float x) {
    return x - bits_float(float_bits(x) & 0xfff00000u);
}

/// The nearest of 0 to 255.
FUNCTION uint round_to_code(float x) {
    return float_bits(at_most(at_least(x, 0.0f), 255.0f) + 8388608.0f) & 255u;
}

KERNELS_END

#define SRGB_ENCODE_SOUND(texels, x)                                          \
    round_to_code(bits_float(texels[SRGB_ENCODE_AT + 2u * encode_entry(x)]) + \
                  encode_step(x) * bits_float(texels[SRGB_ENCODE_AT + 2u * encode_entry(x) + 1u]))
#define SRGB_ENCODE(texels, x) SRGB_ENCODE_SOUND(texels, encodable(x))

/// A colour multiplied by alpha as R, G, B, A in a word.
#define PACK_COLOUR(texels, c)                                                                                        \
    (SRGB_ENCODE(texels, (c).red) | (SRGB_ENCODE(texels, (c).green) << 8u) | (SRGB_ENCODE(texels, (c).blue) << 16u) | \
     (round_to_code((c).alpha * 255.0f) << 24u))

#endif
