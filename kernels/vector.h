// Three-component vectors as plain structs: no vector types, dot and cross written out in one order.
#ifndef TESSERA_VECTOR_H
#define TESSERA_VECTOR_H

#include "exact.h"

KERNELS_BEGIN

STRUCT(Vector) {
    float x;
    float y;
    float z;
};

FUNCTION Vector make_vector(float x, float y, float z) {
    Vector v;
    v.x = x;
    v.y = y;
    v.z = z;
    return v;
}

/// Three consecutive floats of a buffer.
#define LOAD_VECTOR(buffer, at) make_vector(buffer[at], buffer[(at) + 1u], buffer[(at) + 2u])
#define STORE_VECTOR(buffer, at, v) \
    buffer[at] = (v).x;             \
    buffer[(at) + 1u] = (v).y;      \
    buffer[(at) + 2u] = (v).z

FUNCTION Vector add(Vector a, Vector b) {
    return make_vector(a.x + b.x, a.y + b.y, a.z + b.z);
}

FUNCTION Vector subtract(Vector a, Vector b) {
    return make_vector(a.x - b.x, a.y - b.y, a.z - b.z);
}

FUNCTION Vector scale(Vector v, float s) {
    return make_vector(v.x * s, v.y * s, v.z * s);
}

FUNCTION float dot_product(Vector a, Vector b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

FUNCTION Vector cross_product(Vector a, Vector b) {
    return make_vector(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

FUNCTION Vector flush_vector(Vector v) {
    return make_vector(flush_tiny(v.x), flush_tiny(v.y), flush_tiny(v.z));
}

/// The bits of the largest component's magnitude.
FUNCTION uint largest_magnitude(Vector v) {
    const uint x = float_bits(v.x) & 0x7fffffffu;
    const uint y = float_bits(v.y) & 0x7fffffffu;
    const uint z = float_bits(v.z) & 0x7fffffffu;
    const uint larger = x > y ? x : y;
    return larger > z ? larger : z;
}

/// The power of two that brings a magnitude, given by its bits, into [1, 2); 0 for one under 2^-120.
FUNCTION float scale_of_magnitude(uint magnitude) {
    const uint exponent = magnitude >> 23u;
    const bool is_zero = exponent < 7u;
    const uint safe = exponent - 7u > 246u ? 127u : exponent;  // 7 to 253; without a branch, some drivers' bane
    return is_zero ? 0.0f : bits_float((254u - safe) << 23u);
}

/// v times the power of two that brings its largest component into [1, 2); components that are then under 2^-60
/// become 0. Zero (components under 2^-120) stays zero. Exact but for that flush, so that -v gives exactly the negated
/// result.
FUNCTION Vector normalise_exponent(Vector v) {
    return flush_vector(scale(v, scale_of_magnitude(largest_magnitude(v))));
}

/// v / |v|; `fallback` where v is zero.
FUNCTION Vector normalise(Vector v, Vector fallback) {
    const Vector n = normalise_exponent(v);
    const float length_squared = dot_product(n, n);
    const Vector unit = flush_vector(scale(n, exact_rsqrt(length_squared)));
    const bool ok = length_squared > 0.0f;
    return make_vector(ok ? unit.x : fallback.x, ok ? unit.y : fallback.y, ok ? unit.z : fallback.z);
}

KERNELS_END

#endif
