// Perspective-correct barycentric coordinates of a pixel, recomputed from a triangle's corners in clip space.
//
// In coordinates relative to the pixel, a = x - X w and b = y - Y w, the coordinate of corner 0 is proportional to
// a1 b2 - a2 b1, and likewise for the others (Olano and Greer, "Triangle scan conversion using 2D homogeneous
// coordinates", 1997). Corners may lie behind the eye, so clipped triangles need nothing of their own, and the
// differences stay exact enough for triangles far smaller than a pixel.
#ifndef TESSERA_RASTER_INTERPOLATION_H
#define TESSERA_RASTER_INTERPOLATION_H

#include "raster/screen.h"

KERNELS_BEGIN

/// A vertex as shading needs it.
STRUCT(Corner) {
    ClipPoint clip;
    Vector camera;  // position in camera space
    Vector normal;
    float u;
    float v;
};

STRUCT(Weights) {
    float a;
    float b;
    float c;
};

FUNCTION Weights make_weights(float a, float b, float c) {
    Weights w;
    w.a = a;
    w.b = b;
    w.c = c;
    return w;
}

/// Texture coordinates that mean something; others are 0.
FUNCTION float sane_coordinate(float x) {
    return choose(is_below(x, 147u), flush_tiny(x), 0.0f);
}

FUNCTION Corner make_corner(DrawParams p, Vector position, Vector normal, float u, float v) {
    const float x = flush_denormal(position.x);
    const float y = flush_denormal(position.y);
    const float z = flush_denormal(position.z);
    Corner c;
    c.clip.x = clip_row(p.xx, p.xy, p.xz, p.xt, x, y, z);
    c.clip.y = clip_row(p.yx, p.yy, p.yz, p.yt, x, y, z);
    c.clip.z = 0.0f;
    c.clip.w = clip_row(p.wx, p.wy, p.wz, p.wt, x, y, z);
    c.camera.x = clip_row(p.rx, p.ry, p.rz, p.rt, x, y, z);
    c.camera.y = clip_row(p.ux, p.uy, p.uz, p.ut, x, y, z);
    c.camera.z = clip_row(p.bx, p.by, p.bz, p.bt, x, y, z);
    c.normal = flush_vector(normal);
    c.u = sane_coordinate(u);
    c.v = sane_coordinate(v);
    return c;
}

/// Differences under 2^-40 are zero, so that no product of two becomes a denormal.
FUNCTION float relative(float x, float at, float w) {
    const float d = x - at * w;
    return choose(is_below(d, 87u), 0.0f, d);
}

/// A weight within what later products bear.
FUNCTION float bounded_weight(float x) {
    const float y = at_most(at_least(x, -1073741824.0f), 1073741824.0f);
    return choose(is_below(y, 97u), 0.0f, y);
}

/// exact_reciprocal() without branches, which some drivers (SwiftShader) take minutes to compile by the hundred.
FUNCTION float chosen_reciprocal(float x) {
    const uint bits = float_bits(x);
    const uint exponent = (bits >> 23u) & 0xffu;
    const uint mantissa = bits & 0x007fffffu;
    const uint edge = choose_bits(exponent == 0u, 1u, 0u) | choose_bits(exponent == 255u, 1u, 0u);
    const float m = bits_float(mantissa | 0x3f800000u);
    float r = bits_float(0x7ef311c7u - float_bits(m));
    r = r * (2.0f - m * r);
    r = r * (2.0f - m * r);
    r = r * (2.0f - m * r);
    r = r + r * (1.0f - m * r);
    const uint sum = (float_bits(r) >> 23u) + 127u;
    const uint shifted = (float_bits(r) & 0x007fffffu) | ((sum - exponent) << 23u);
    const uint finite = choose_bits(sum > exponent, shifted, 0u);
    const uint special = choose_bits(exponent == 0u, 0x7f800000u, choose_bits(mantissa == 0u, 0u, 0x7fc00000u));
    return bits_float((bits & 0x80000000u) | choose_bits(edge != 0u, special, finite));
}

/// Weights at the point (x, y) of the plane of the triangle, which may lie outside it. They add up to one.
FUNCTION Weights weights_at(ClipPoint a, ClipPoint b, ClipPoint c, float x, float y) {
    const float ax = relative(a.x, x, a.w);
    const float ay = relative(a.y, y, a.w);
    const float bx = relative(b.x, x, b.w);
    const float by = relative(b.y, y, b.w);
    const float cx = relative(c.x, x, c.w);
    const float cy = relative(c.y, y, c.w);
    const float wa = bx * cy - by * cx;
    const float wb = cx * ay - cy * ax;
    const float wc = ax * by - ay * bx;
    const float sum = (wa + wb) + wc;
    const float r = chosen_reciprocal(sum);
    const bool flat_on = sum == 0.0f;
    Weights w;
    w.a = choose(flat_on, 1.0f, bounded_weight(wa * r));
    w.b = choose(flat_on, 0.0f, bounded_weight(wb * r));
    w.c = choose(flat_on, 0.0f, bounded_weight(wc * r));
    return w;
}

FUNCTION Weights subtract_weights(Weights v, Weights w) {
    Weights d;
    d.a = bounded_weight(v.a - w.a);
    d.b = bounded_weight(v.b - w.b);
    d.c = bounded_weight(v.c - w.c);
    return d;
}

FUNCTION float product_of_steps(float across_a, float across_b, float down_a, float down_b) {
    return flush_tiny(across_a * across_b + down_a * down_b);
}

/// The point of the triangle that is nearest to weights that may lie outside it, in pixels: they are moved to the edge
/// that they lie beyond, at right angles on the screen, and what is negative then becomes zero. `across` and `down` are
/// their changes to the neighbours of a pixel. (Without the move, points beside needles would slide along them.) A
/// pixel that a triangle covers only beside its middle gets a value that the triangle has there.
FUNCTION Weights weights_inside(Weights w, Weights across, Weights down) {
    const float least = at_most(at_most(w.a, w.b), w.c);
    const bool is_a = w.a == least;
    const bool is_b = w.b == least;
    const float step_x = choose(is_a, across.a, choose(is_b, across.b, across.c));
    const float step_y = choose(is_a, down.a, choose(is_b, down.b, down.c));
    const float squared = product_of_steps(step_x, step_x, step_y, step_y);
    // A covered pixel is less than two pixels away: what seems farther is an accident of rounding. NaN is not nearer.
    const uint near = choose_bits(least < 0.0f, 1u, 0u) & choose_bits(least * least < 4.0f * squared, 1u, 0u);
    const float r = chosen_reciprocal(choose(near != 0u, squared, 1.0f));
    const float way = choose(near != 0u, flush_tiny(least * r), 0.0f);
    const float a = at_least(w.a - way * product_of_steps(across.a, step_x, down.a, step_y), 0.0f);
    const float b = at_least(w.b - way * product_of_steps(across.b, step_x, down.b, step_y), 0.0f);
    const float c = at_least(w.c - way * product_of_steps(across.c, step_x, down.c, step_y), 0.0f);
    const float sum = (a + b) + c;
    const bool some = sum > 0.0f;
    const float scale = choose(some, chosen_reciprocal(choose(some, sum, 1.0f)), 0.0f);
    Weights inside;
    inside.a = choose(some, bounded_weight(a * scale), 1.0f);
    inside.b = bounded_weight(b * scale);
    inside.c = bounded_weight(c * scale);
    return inside;
}

/// Weights at the middle of pixel (x, y) of the image.
FUNCTION Weights pixel_weights(DrawParams p, Corner a, Corner b, Corner c, uint x, uint y) {
    return weights_at(a.clip, b.clip, c.clip, (to_float(x) + 0.5f) * p.pixel_x - 1.0f,
                      (to_float(y) + 0.5f) * p.pixel_y - 1.0f);
}

FUNCTION float weigh(Weights w, float a, float b, float c) {
    return flush_tiny((w.a * a + w.b * b) + w.c * c);
}

FUNCTION Vector weigh_vectors(Weights w, Vector a, Vector b, Vector c) {
    return make_vector(weigh(w, a.x, b.x, c.x), weigh(w, a.y, b.y, c.y), weigh(w, a.z, b.z, c.z));
}

KERNELS_END

#endif
