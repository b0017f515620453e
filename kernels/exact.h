// Division, reciprocal, reciprocal square root, exponential and logarithm from + - x and integers alone, so that every
// device gives the same bits. Vulkan allows 2.5 ULP for `/` and 2 ULP for inversesqrt; these take an integer seed and
// fixed Newton steps on a mantissa in [1, 4) and put the exponent back as an integer, so that no intermediate is a
// denormal.
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
    // x = m * 4^k with m in [1, 4); `power` is k + 64 in the exponent's place, twice.
    const uint bits = float_bits(x);
    const uint power = (bits + 0x00800000u) & 0xff000000u;
    const float m = bits_float(bits - power + 0x40000000u);
    float y = bits_float(0x5f375a86u - (float_bits(m) >> 1u));  // 3.5 % off
    y = y * (1.5f - (0.5f * m) * (y * y));
    y = y * (1.5f - (0.5f * m) * (y * y));
    y = y + (0.5f * y) * (1.0f - (m * y) * y);
    return bits_float(float_bits(y) - (power >> 1u) + 0x20000000u);
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

/// 2^x within 1.14 ULP for x in [-126, 128); 0 below, infinity above, NaN for NaN. 2^f for
/// f in [-1/2, 1/2] is 1 + f p(f), with the polynomial of degree 5 through the values at the Chebyshev points.
FUNCTION float exact_exp2(float x) {
    const float low = x > -127.0f ? x : -127.0f;  // NaN too
    const float bounded = low < 129.0f ? low : 129.0f;
    const uint shifted = float_bits(bounded + 12582912.0f);  // the nearest integer in the lowest bits
    const float f = bounded - (bits_float(shifted) - 12582912.0f);
    float p = 0.000154531634f;
    p = p * f + 0.00133908633f;
    p = p * f + 0.00961808302f;
    p = p * f + 0.0555035695f;
    p = p * f + 0.240226507f;
    p = p * f + 0.693147182f;
    p = p * f + 1.0f;
    const uint result = float_bits(p) + ((shifted - 0x4b400000u) << 23u);
    const uint above = x >= 128.0f ? 0x7f800000u : result;
    const uint finite = x >= -126.0f ? above : 0u;
    return bits_float(x == x ? finite : 0x7fc00000u);
}

/// log2(x) within 2.2 ULP for normal, finite x > 0. Any other x gives some number or other. The mantissa is taken in
/// [sqrt(1/2), sqrt(2)), so that log2(1) is 0 exactly and numbers close to 1 keep their digits; the polynomial is that
/// of degree 8 through the values of log2(1 + f) / f at the Chebyshev points.
FUNCTION float exact_log2(float x) {
    const uint bits = float_bits(x);
    const uint shifted = bits - 0x3f3504f3u;  // of sqrt(1/2)
    const uint exponent = (shifted >> 23u) - ((shifted & 0x80000000u) != 0u ? 512u : 0u);
    const float f = bits_float(bits - (exponent << 23u)) - 1.0f;
    float p = 0.123109683f;
    p = p * f + -0.205861881f;
    p = p * f + 0.216078222f;
    p = p * f + -0.239169881f;
    p = p * f + 0.287903249f;
    p = p * f + -0.360693276f;
    p = p * f + 0.480910748f;
    p = p * f + -0.721347451f;
    p = p * f + 1.44269502f;
    return to_float(exponent) + f * p;
}

/// x^y for x in [0, 1] and y in (0, 2^20] as light needs it, within 5e-6 of its value: the error of y log2(x), which is
/// at most 60. 0 where x or the result is under 2^-60.
FUNCTION float exact_power(float x, float y) {
    const bool none = x < 8.673617379884035e-19f;  // 2^-60
    const float power = exact_exp2(y * exact_log2(none ? 1.0f : x));
    return none ? 0.0f : flush_tiny(power);
}

KERNELS_END

#endif
