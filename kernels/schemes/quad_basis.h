// Tensor-product Bernstein bases, degrees 1 to 3: along v first, then along u. On an edge one of the two directions has
// weights of exactly 1 and 0, and what is left is the sum that basis.h makes on an edge of a triangle, so that quads
// and triangles meet with the same bits.
#ifndef TESSERA_SCHEMES_QUAD_BASIS_H
#define TESSERA_SCHEMES_QUAD_BASIS_H

#include "vector.h"

KERNELS_BEGIN

/// Weights along one direction from its start `a` to its end `b`.
STRUCT(CurveWeights) {
    float a;   // of the start
    float ab;  // of the point next to the start, or of the middle point
    float ba;  // of the point next to the end; unused below degree 3
    float b;   // of the end
};

/// Weights at a coordinate in 16.16. `binomial` is the factor of the middle term of degree 2; see basis.h.
FUNCTION CurveWeights curve_weights_linear(uint t) {
    CurveWeights w;
    w.a = to_float(65536u - t) * 0.0000152587890625f;
    w.b = to_float(t) * 0.0000152587890625f;
    w.ab = 0.0f;
    w.ba = 0.0f;
    return w;
}

FUNCTION CurveWeights curve_weights_quadratic(uint t, float binomial) {
    const CurveWeights l = curve_weights_linear(t);
    CurveWeights w;
    w.a = l.a * l.a;
    w.b = l.b * l.b;
    w.ab = (l.a * l.b) * binomial;
    w.ba = 0.0f;
    return w;
}

FUNCTION CurveWeights curve_weights_cubic(uint t) {
    const CurveWeights l = curve_weights_linear(t);
    CurveWeights w;
    w.a = (l.a * l.a) * l.a;
    w.b = (l.b * l.b) * l.b;
    w.ab = (3.0f * (l.a * l.a)) * l.b;
    w.ba = (3.0f * (l.b * l.b)) * l.a;
    return w;
}

FUNCTION float curve_linear(CurveWeights w, float a, float b) {
    return w.a * a + w.b * b;
}

FUNCTION float curve_quadratic(CurveWeights w, float a, float ab, float b) {
    return (w.a * a + w.b * b) + w.ab * ab;
}

FUNCTION float curve_cubic(CurveWeights w, float a, float ab, float ba, float b) {
    return (w.a * a + w.ab * ab) + (w.b * b + w.ba * ba);
}

FUNCTION float blend_bilinear(CurveWeights u, CurveWeights v, float c0, float c1, float c2, float c3) {
    return curve_linear(u, curve_linear(v, c0, c3), curve_linear(v, c1, c2));
}

FUNCTION Vector evaluate_bilinear(CurveWeights u, CurveWeights v, Vector c0, Vector c1, Vector c2, Vector c3) {
    return make_vector(blend_bilinear(u, v, c0.x, c1.x, c2.x, c3.x), blend_bilinear(u, v, c0.y, c1.y, c2.y, c3.y),
                       blend_bilinear(u, v, c0.z, c1.z, c2.z, c3.z));
}

/// Biquadratic: corners, edge points in the order 01, 12, 23, 30, and the centre.
FUNCTION Vector evaluate_biquadratic(CurveWeights u, CurveWeights v, Vector c0, Vector c1, Vector c2, Vector c3,
                                     Vector c01, Vector c12, Vector c23, Vector c30, Vector centre) {
    return make_vector(
        curve_quadratic(u, curve_quadratic(v, c0.x, c30.x, c3.x), curve_quadratic(v, c01.x, centre.x, c23.x),
                        curve_quadratic(v, c1.x, c12.x, c2.x)),
        curve_quadratic(u, curve_quadratic(v, c0.y, c30.y, c3.y), curve_quadratic(v, c01.y, centre.y, c23.y),
                        curve_quadratic(v, c1.y, c12.y, c2.y)),
        curve_quadratic(u, curve_quadratic(v, c0.z, c30.z, c3.z), curve_quadratic(v, c01.z, centre.z, c23.z),
                        curve_quadratic(v, c1.z, c12.z, c2.z)));
}

/// A column of a bicubic patch: its curve along v.
FUNCTION Vector column_cubic(CurveWeights v, Vector a, Vector ab, Vector ba, Vector b) {
    return make_vector(curve_cubic(v, a.x, ab.x, ba.x, b.x), curve_cubic(v, a.y, ab.y, ba.y, b.y),
                       curve_cubic(v, a.z, ab.z, ba.z, b.z));
}

/// Likewise of a biquadratic patch.
FUNCTION Vector column_quadratic(CurveWeights v, Vector a, Vector ab, Vector b) {
    return make_vector(curve_quadratic(v, a.x, ab.x, b.x), curve_quadratic(v, a.y, ab.y, b.y),
                       curve_quadratic(v, a.z, ab.z, b.z));
}

/// A point of a line.
FUNCTION Vector line_point(CurveWeights w, Vector a, Vector b) {
    return make_vector(curve_linear(w, a.x, b.x), curve_linear(w, a.y, b.y), curve_linear(w, a.z, b.z));
}

KERNELS_END

#endif
