// Tangent frames: the unit directions in which a surface's or a texture's coordinates grow, from the surface's
// derivatives.
// Source: Dupuy, Phong Tessellation for Quads, equations 4 to 11 (there for one scheme; the derivatives of a Bezier
// patch serve all); the frame of normal maps as in Lengyel, Computing Tangent Space Basis Vectors for an Arbitrary
// Mesh, 2001, with the surface's derivatives in the place of edges.
#ifndef TESSERA_SCHEMES_TANGENT_FRAME_H
#define TESSERA_SCHEMES_TANGENT_FRAME_H

#include "layout.h"
#include "vector.h"

KERNELS_BEGIN

/// Unit vectors, not at right angles as a rule. bitangent = handedness * cross(normal, tangent) but for length and the
/// angle between the two.
STRUCT(TangentFrame) {
    Vector tangent;
    Vector bitangent;
    float handedness;  // 1 or -1
};

// Vectors of frames are near unit length, and components under 2^-40 count as zero: products of two, differences of
// such products, and one more product with either are then never denormal.
#define FRAME_TINY_BITS 0x2b800000u

FUNCTION float flush_frame(float x) {
    return (float_bits(x) & 0x7fffffffu) < FRAME_TINY_BITS ? 0.0f : x;
}

FUNCTION Vector flush_frame_vector(Vector v) {
    return make_vector(flush_frame(v.x), flush_frame(v.y), flush_frame(v.z));
}

// No choice in this file is a branch (&& and || are): with those, drivers take seconds to compile it.
FUNCTION bool is_zero_vector(Vector v) {
    return ((float_bits(v.x) | float_bits(v.y) | float_bits(v.z)) & 0x7fffffffu) == 0u;
}

FUNCTION Vector choose_vector(bool first, Vector a, Vector b) {
    return make_vector(first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z);
}

/// The axis that a unit vector is farthest from.
FUNCTION Vector farthest_axis(Vector v) {
    const uint x = float_bits(v.x) & 0x7fffffffu;
    const uint y = float_bits(v.y) & 0x7fffffffu;
    const uint z = float_bits(v.z) & 0x7fffffffu;
    const uint smaller = x < y ? x : y;
    const uint least = smaller < z ? smaller : z;
    const float by_x = x == least ? 1.0f : 0.0f;
    const float by_y = y == least ? 1.0f - by_x : 0.0f;
    return make_vector(by_x, by_y, (1.0f - by_x) - by_y);
}

/// The frame along `along_u` and `along_v`, of any lengths, at a vertex with the unit normal `normal`. In the place of
/// one that vanishes comes a vector at right angles to the other and the normal, in that of both any two at right
/// angles to each other and the normal. `mirror` (1 or -1) is then multiplied into the bitangent.
FUNCTION TangentFrame make_mirrored_frame(Vector along_u, Vector along_v, float mirror, Vector normal) {
    const Vector n = flush_frame_vector(normal);
    const Vector u = flush_frame_vector(normalise_exponent(along_u));
    const Vector v = flush_frame_vector(normalise_exponent(along_v));
    const Vector axis = farthest_axis(n);
    const Vector across_v = cross_product(choose_vector(is_zero_vector(v), axis, v), n);
    TangentFrame frame;
    frame.tangent = flush_frame_vector(normalise(choose_vector(is_zero_vector(u), across_v, u), axis));
    const Vector across_u = flush_frame_vector(cross_product(n, frame.tangent));
    const Vector bitangent = normalise(choose_vector(is_zero_vector(v), across_u, v), axis);
    frame.bitangent = flush_frame_vector(scale(bitangent, mirror));
    frame.handedness = dot_product(across_u, frame.bitangent) < 0.0f ? -1.0f : 1.0f;
    return frame;
}

/// The surface's own frame, from its derivatives.
FUNCTION TangentFrame make_frame(Vector by_u, Vector by_v, Vector normal) {
    return make_mirrored_frame(by_u, by_v, 1.0f, normal);
}

/// How one texture coordinate varies along the domain's u and v, but for a positive factor.
STRUCT(TextureSlope) {
    float by_u;
    float by_v;
};

/// An eighth of b - a: the whole could overflow, for texture coordinates may be any finite numbers.
FUNCTION float texture_step(float a, float b) {
    return 0.125f * b - 0.125f * a;
}

FUNCTION TextureSlope make_texture_slope(float by_u, float by_v) {
    const uint u = float_bits(by_u) & 0x7fffffffu;
    const uint v = float_bits(by_v) & 0x7fffffffu;
    const float to_one = scale_of_magnitude(u > v ? u : v);
    TextureSlope s;
    s.by_u = flush_frame(by_u * to_one);
    s.by_v = flush_frame(by_v * to_one);
    return s;
}

FUNCTION float magnitude(float x) {
    return bits_float(float_bits(x) & 0x7fffffffu);
}

/// The frame of normal maps: along growing texture coordinate s with t constant, and the reverse. Where the texture
/// coordinates vary along one line only (but for rounding), or a derivative vanishes, the surface's own frame stands
/// in, with the bitangent reversed where the texture is mirrored, so that handedness stays that of the neighbours.
FUNCTION TangentFrame make_texture_frame(Vector by_u, Vector by_v, TextureSlope s, TextureSlope t, Vector normal) {
    const uint largest_u = largest_magnitude(by_u);
    const uint largest_v = largest_magnitude(by_v);
    const float to_one = scale_of_magnitude(largest_u > largest_v ? largest_u : largest_v);
    const Vector u = flush_frame_vector(scale(by_u, to_one));
    const Vector v = flush_frame_vector(scale(by_v, to_one));
    const float p = s.by_u * t.by_v;
    const float q = s.by_v * t.by_u;
    const float determinant = p - q;
    const float noise = (magnitude(p) + magnitude(q)) * 0.00000095367431640625f;  // 2^-20
    const bool is_line = magnitude(determinant) <= noise;
    const float sign = is_line ? 1.0f : (determinant < 0.0f ? -1.0f : 1.0f);
    const Vector along_s = scale(subtract(scale(u, t.by_v), scale(v, t.by_u)), sign);
    const Vector along_t = scale(subtract(scale(v, s.by_u), scale(u, s.by_v)), sign);
    const uint vanishing = (is_line ? 1u : 0u) | (is_zero_vector(u) ? 1u : 0u) | (is_zero_vector(v) ? 1u : 0u) |
                           (is_zero_vector(along_s) ? 1u : 0u) | (is_zero_vector(along_t) ? 1u : 0u);
    const bool none = vanishing != 0u;
    return make_mirrored_frame(choose_vector(none, by_u, along_s), choose_vector(none, by_v, along_t),
                               none ? sign : 1.0f, normal);
}

/// As vertex k of an array that holds RUN of each word.
#define PUT_FRAME_INTO_RUN(run, k, f)      \
    run[k] = (f).tangent.x;                \
    run[RUN + (k)] = (f).tangent.y;        \
    run[2u * RUN + (k)] = (f).tangent.z;   \
    run[3u * RUN + (k)] = (f).handedness;  \
    run[4u * RUN + (k)] = (f).bitangent.x; \
    run[5u * RUN + (k)] = (f).bitangent.y; \
    run[6u * RUN + (k)] = (f).bitangent.z; \
    run[7u * RUN + (k)] = 0.0f

KERNELS_END

#endif
