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

/// |x| < 2^40; false for NaN.
FUNCTION bool is_moderate(float x) {
    return (float_bits(x) & 0x7fffffffu) < 0x53800000u;
}

/// Where a point of clip space lies on the screen. Points that are not in front of the eye (w < 2^-20), or are beyond
/// the guard band, get OUT_CLIP and the place of the middle.
FUNCTION ScreenPoint to_screen(DrawParams p, ClipPoint c) {
    const bool valid = is_moderate(c.x) && is_moderate(c.y) && is_moderate(c.z) && is_moderate(c.w);
    uint code = 0u;
    code = code | (c.x < -c.w ? OUT_LEFT : 0u);
    code = code | (c.x > c.w ? OUT_RIGHT : 0u);
    code = code | (c.y < -c.w ? OUT_TOP : 0u);
    code = code | (c.y > c.w ? OUT_BOTTOM : 0u);
    code = code | (c.z < 0.0f ? OUT_NEAR : 0u);
    code = code | (c.z > c.w ? OUT_FAR : 0u);
    const bool in_front = valid && c.w >= 9.5367431640625e-7f;
    const float w = in_front ? c.w : 1.0f;
    const float r = exact_reciprocal(w);
    const float x = ((in_front ? c.x : 0.0f) * r) * p.half_width;
    const float y = ((in_front ? c.y : 0.0f) * r) * p.half_height;
    const float z = (in_front ? c.z : 0.0f) * r;
    const bool inside = in_front && x >= -RASTER_GUARD_FLOAT && x <= RASTER_GUARD_FLOAT && y >= -RASTER_GUARD_FLOAT &&
                        y <= RASTER_GUARD_FLOAT;
    ScreenPoint s;
    s.x = round_to_int(inside ? x : 0.0f);
    s.y = round_to_int(inside ? y : 0.0f);
    // Depths under 2^-30 are zero, so that no slope of depth becomes a denormal.
    s.z = inside && (float_bits(z) & 0x7fffffffu) >= 0x30800000u ? z : 0.0f;
    s.code = valid ? (inside ? code : (code | OUT_CLIP)) : OUT_INVALID;
    return s;
}

KERNELS_END

#endif
