// Guide curves: a Catmull-Rom spline through the points of a guide, as one cubic Bezier curve per segment. It goes
// through every point; at root and tip it leaves along the first and arrives along the last chord.
// Source: Catmull, Rom, A class of local interpolating splines, 1974.
#ifndef TESSERA_HAIR_GUIDE_CURVE_H
#define TESSERA_HAIR_GUIDE_CURVE_H

#include "layout.h"
#include "schemes/quad_basis.h"

KERNELS_BEGIN

// Hair multiplies more weights than surfaces do, so its numbers count as zero under 2^-30 already: that is far below
// the precision of a model whose largest coordinate is 1, and no product or difference of theirs can be denormal.
#define HAIR_TINY_BITS 0x30800000u

FUNCTION float flush_hair(float x) {
    return (float_bits(x) & 0x7fffffffu) < HAIR_TINY_BITS ? 0.0f : x;
}

FUNCTION Vector flush_hair_vector(Vector v) {
    return make_vector(flush_hair(v.x), flush_hair(v.y), flush_hair(v.z));
}

/// The Bezier point next to `p` on the side of `after`, where `before` lies on the other side of p.
FUNCTION Vector guide_bezier_point(Vector p, Vector before, Vector after) {
    const float sixth = 0.16666667163372039794921875f;  // of a float, the nearest to 1/6
    return flush_hair_vector(add(p, scale(flush_hair_vector(subtract(after, before)), sixth)));
}

/// The point that the spline would need beyond an end `p`: the reflection of its neighbour.
FUNCTION Vector beyond_guide_end(Vector p, Vector neighbour) {
    return subtract(add(p, p), neighbour);
}

/// One segment: Bezier points, and what varies linearly.
STRUCT(GuideCurve) {
    Vector a;
    Vector ab;
    Vector ba;
    Vector b;
    float width_a;
    float width_b;
    Vector normal_a;
    Vector normal_b;
};

#define LOAD_GUIDE_CURVE(curve, curves, at)           \
    curve.a = LOAD_VECTOR(curves, at);                \
    curve.ab = LOAD_VECTOR(curves, (at) + 3u);        \
    curve.ba = LOAD_VECTOR(curves, (at) + 6u);        \
    curve.b = LOAD_VECTOR(curves, (at) + 9u);         \
    curve.width_a = curves[(at) + 12u];               \
    curve.width_b = curves[(at) + 13u];               \
    curve.normal_a = LOAD_VECTOR(curves, (at) + 14u); \
    curve.normal_b = LOAD_VECTOR(curves, (at) + 17u)

/// A place on a guide: one of its segments and the coordinate there, 16.16.
STRUCT(GuidePlace) {
    uint segment;
    uint t;
};

/// Where u (16.16) of a guide with `count` segments lies; every segment takes an equal share of u. count <= 65535.
FUNCTION GuidePlace guide_place(uint count, uint u) {
    GuidePlace place;
    const uint along = u * count;
    const uint segment = along >> 16u;
    place.segment = segment < count ? segment : count - 1u;
    place.t = along - (place.segment << 16u);
    return place;
}

/// What a guide or a hair is at one place. The tangent is the derivative by u, a third of it.
STRUCT(HairPoint) {
    Vector position;
    Vector tangent;
    Vector normal;
    float width;
};

FUNCTION HairPoint guide_point(GuideCurve c, uint segments, uint t) {
    const CurveWeights l = curve_weights_linear(t);
    const CurveWeights q = curve_weights_quadratic(t, 2.0f);
    const CurveWeights w = curve_weights_cubic(t);
    const Vector d0 = subtract(c.ab, c.a);
    const Vector d1 = subtract(c.ba, c.ab);
    const Vector d2 = subtract(c.b, c.ba);
    HairPoint p;
    p.position = flush_hair_vector(column_cubic(w, c.a, c.ab, c.ba, c.b));
    const Vector slope = make_vector(curve_quadratic(q, d0.x, d1.x, d2.x), curve_quadratic(q, d0.y, d1.y, d2.y),
                                     curve_quadratic(q, d0.z, d1.z, d2.z));
    p.tangent = flush_hair_vector(scale(slope, to_float(segments)));
    p.normal = flush_hair_vector(make_vector(curve_linear(l, c.normal_a.x, c.normal_b.x),
                                             curve_linear(l, c.normal_a.y, c.normal_b.y),
                                             curve_linear(l, c.normal_a.z, c.normal_b.z)));
    p.width = flush_hair(curve_linear(l, c.width_a, c.width_b));
    return p;
}

KERNELS_END

#endif
