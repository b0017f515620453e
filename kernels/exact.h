// Division, reciprocal and reciprocal square root from + - x and integers alone, so that every device gives the same
// bits. Vulkan allows 2.5 ULP for `/` and 2 ULP for inversesqrt; these take an integer seed and fixed Newton steps on a
// mantissa in [1, 4) and put the exponent back as an integer, so that no intermediate is a denormal.
#ifndef TESSERA_EXACT_H
#define TESSERA_EXACT_H

#include "dialect.h"

KERNELS_BEGIN

// Magnitudes under 2^-60 count as zero: their products would be denormal, which some devices flush and others keep.
#define TINY_BITS 0x21800000u

/// x, or +0 where |x| < 2^-60. Turns -0 into +0 too.
FUNCTION float flush_tiny(float x) {
    return (float_bits(x) & 0x7fffffffu) < TINY_BITS ? 0.0f : x;
}

/// 1/x within 1.25 ULP for 2^-126 <= |x| <= 2^126: at most one float away from the correctly rounded result. Beyond: 0
/// and denormals give an infinity, greater magnitudes and infinities give 0, each with the sign of x; NaN gives NaN.
FUNCTION float exact_reciprocal(float x) {
    const uint bits = float_bits(x);
    const uint sign = bits & 0x80000000u;
    const uint exponent = (bits >> 23u) & 0xffu;
    const uint mantissa = bits & 0x007fffffu;
    const float m = bits_float(mantissa | 0x3f800000u);  // in [1, 2)
    float r = bits_float(0x7ef311c7u - float_bits(m));   // 12 % off; each step squares the error
    r = r * (2.0f - m * r);
    r = r * (2.0f - m * r);
    r = r * (2.0f - m * r);
    r = r + r * (1.0f - m * r);
    const uint r_bits = float_bits(r);        // in [0.5, 1]
    const uint sum = (r_bits >> 23u) + 127u;  // the result's exponent is sum - exponent
    const uint shifted = (r_bits & 0x007fffffu) | ((sum - exponent) << 23u);
    const uint finite = sum > exponent ? shifted : 0u;
    const uint special = exponent == 0u ? 0x7f800000u : (mantissa == 0u ? 0u : 0x7fc00000u);
    return bits_float(sign | (exponent == 0u || exponent == 255u ? special : finite));
}

/// 1/sqrt(x) within 1.22 ULP for normal, finite x > 0: at most one float away from the correctly rounded result. Any
/// other x gives some number or other.
FUNCTION float exact_rsqrt_of_normal(float x) {
    const uint bits = float_bits(x);
    const uint exponent = (bits >> 23u) & 0xffu;
    const uint mantissa = bits & 0x007fffffu;
    // x = m * 4^k with m in [1, 4) and k = (exponent + 1) / 2 - 64.
    const float m = bits_float(mantissa | ((exponent & 1u) == 0u ? 0x40000000u : 0x3f800000u));
    float y = bits_float(0x5f375a86u - (float_bits(m) >> 1u));  // 3.5 % off
    y = y * (1.5f - (0.5f * m) * (y * y));
    y = y * (1.5f - (0.5f * m) * (y * y));
    y = y + (0.5f * y) * (1.0f - (m * y) * y);
    return bits_float(float_bits(y) + ((64u - ((exponent + 1u) >> 1u)) << 23u));
}

/// 1/sqrt(x) likewise. 0 and denormals give +infinity, infinity gives 0, NaN and negative numbers give NaN.
FUNCTION float exact_rsqrt(float x) {
    const uint bits = float_bits(x);
    const bool is_normal = (bits - 0x00800000u) < 0x7f000000u;
    const uint special = (bits & 0x7f800000u) == 0u ? 0x7f800000u : (bits == 0x7f800000u ? 0u : 0x7fc00000u);
    const float result = exact_rsqrt_of_normal(is_normal ? x : 1.0f);
    return bits_float(is_normal ? float_bits(result) : special);
}

/// a/b within 2.17 ULP where b is as in exact_reciprocal and neither a nor the quotient is denormal or overflows.
FUNCTION float exact_divide(float a, float b) {
    return a * exact_reciprocal(b);
}

KERNELS_END

#endif
