// From clip space to fixed-point places on the screen.
#ifndef TESSERA_RASTER_SCREEN_H
#define TESSERA_RASTER_SCREEN_H

#include "raster/raster_layout.h"
#include "vector.h"

KERNELS_BEGIN

STRUCT(ClipPoint) {
    float x;
    float y;
    float z;
    float w;
};

STRUCT(ScreenPoint) {
    int x;    // sub-pixels from the middle of the image
    int y;    // downwards
    float z;  // depth: 0 near, 1 far
    uint code;
};

/// a or b, both computed. Nested conditions become branches, which cost more and which some drivers (SwiftShader) take
/// minutes to compile by the hundred.
FUNCTION float choose(bool first, float a, float b) {
    return first ? a : b;
}
FUNCTION uint choose_bits(bool first, uint a, uint b) {
    return first ? a : b;
}
FUNCTION float at_least(float x, float low) {
    return choose(x > low, x, low);
}
FUNCTION float at_most(float x, float high) {
    return choose(x < high, x, high);
}

/// |x| < 2^(exponent - 127); false for NaN.
FUNCTION bool is_below(float x, uint exponent) {
    return (float_bits(x) & 0x7fffffffu) < (exponent << 23u);
}

/// The integer nearest to x (ties to even) for |x| < 2^22; other numbers give some integer.
FUNCTION int round_to_int(float x) {
    return to_int(float_bits(x + 12582912.0f) - 0x4b400000u);
}

/// The part of x that the arithmetic to come can bear: numbers under 2^-60 are zero.
FUNCTION float clip_row(float a, float b, float c, float t, float x, float y, float z) {
    return flush_tiny(((a * x + b * y) + c * z) + t);
}

/// A denormal is zero before the first product.
FUNCTION float flush_denormal(float x) {
    return (float_bits(x) & 0x7f800000u) == 0u ? 0.0f : x;
}

FUNCTION ClipPoint to_clip_space(DrawParams p, float px, float py, float pz) {
    const float x = flush_denormal(px);
    const float y = flush_denormal(py);
    const float z = flush_denormal(pz);
    ClipPoint c;
    c.x = clip_row(p.xx, p.xy, p.xz, p.xt, x, y, z);
    c.y = clip_row(p.yx, p.yy, p.yz, p.yt, x, y, z);
    c.z = clip_row(p.zx, p.zy, p.zz, p.zt, x, y, z);
    c.w = clip_row(p.wx, p.wy, p.wz, p.wt, x, y, z);
    return c;
}

/// Where a point of clip space lies on the screen. Points that are not in front of the eye (w < 2^-20), or are beyond
/// the guard band, get OUT_CLIP and the place of the middle.
FUNCTION ScreenPoint to_screen(DrawParams p, ClipPoint c) {
    // Faults are bits: "and" of conditions would be branches.
    const uint fault = ((choose_bits(is_below(c.x, 167u), 0u, 1u) | choose_bits(is_below(c.y, 167u), 0u, 1u)) |
                        choose_bits(is_below(c.z, 167u), 0u, 1u)) |
                       choose_bits(is_below(c.w, 167u), 0u, 1u);
    uint code = choose_bits(c.x < -c.w, OUT_LEFT, 0u);
    code = code | choose_bits(c.x > c.w, OUT_RIGHT, 0u);
    code = code | choose_bits(c.y < -c.w, OUT_TOP, 0u);
    code = code | choose_bits(c.y > c.w, OUT_BOTTOM, 0u);
    code = code | choose_bits(c.z < 0.0f, OUT_NEAR, 0u);
    code = code | choose_bits(c.z > c.w, OUT_FAR, 0u);
    const uint behind = fault | choose_bits(c.w >= 9.5367431640625e-7f, 0u, 1u);
    const bool in_front = behind == 0u;
    const float r = exact_reciprocal(choose(in_front, c.w, 1.0f));
    const float x = (choose(in_front, c.x, 0.0f) * r) * p.half_width;
    const float y = (choose(in_front, c.y, 0.0f) * r) * p.half_height;
    const float z = choose(in_front, c.z, 0.0f) * r;
    const uint beyond =
        ((choose_bits(x >= -RASTER_GUARD_FLOAT, 0u, 1u) | choose_bits(x <= RASTER_GUARD_FLOAT, 0u, 1u)) |
         choose_bits(y >= -RASTER_GUARD_FLOAT, 0u, 1u)) |
        choose_bits(y <= RASTER_GUARD_FLOAT, 0u, 1u);
    const bool inside = (behind | beyond) == 0u;
    ScreenPoint s;
    s.x = round_to_int(choose(inside, x, 0.0f));
    s.y = round_to_int(choose(inside, y, 0.0f));
    // Depths under 2^-30 are zero, so that no slope of depth becomes a denormal.
    s.z = choose(inside, choose(is_below(z, 97u), 0.0f, z), 0.0f);
    s.code = choose_bits(fault == 0u, code | choose_bits(inside, 0u, OUT_CLIP), OUT_INVALID);
    return s;
}

KERNELS_END

/// The place in `vertices` and `attributes` of the vertex that word i of a batch's indices names. Signed, as where
/// vertices are loaded.
#define DRAW_VERTEX(p, i) ((p).first_vertex + (indices[to_int((p).index_at) + to_int(i)] - (p).index_base))

#endif
