// Bernstein bases of triangles, degrees 1 to 3, summed so that a point on an edge has the same bits from either patch:
// terms are grouped by corner, each group depends on its corner's role alone, groups and pairs are added by sums of two
// (which commute), and the terms of the other edges are exact zeros there.
#ifndef TESSERA_SCHEMES_BASIS_H
#define TESSERA_SCHEMES_BASIS_H

#include "vector.h"

KERNELS_BEGIN

/// Barycentric coordinates, exact multiples of 2^-16 that add up to 1 exactly.
STRUCT(Barycentric) {
    float u;
    float v;
    float w;
};

/// From a domain point in 16.16.
FUNCTION Barycentric make_barycentric(uint u, uint v) {
    Barycentric b;
    b.u = to_float(u) * 0.0000152587890625f;
    b.v = to_float(v) * 0.0000152587890625f;
    b.w = to_float(65536u - u - v) * 0.0000152587890625f;
    return b;
}

FUNCTION float blend_linear(Barycentric b, float c0, float c1, float c2) {
    return (b.u * c0 + b.v * c1) + b.w * c2;
}

FUNCTION Vector evaluate_linear(Barycentric b, Vector c0, Vector c1, Vector c2) {
    return make_vector(blend_linear(b, c0.x, c1.x, c2.x), blend_linear(b, c0.y, c1.y, c2.y),
                       blend_linear(b, c0.z, c1.z, c2.z));
}

/// Six weights of degree 2. The binomial factor of the mixed terms is the caller's: 2 for Bezier points; 1 for the
/// normals of Vlachos et al. 2001, which they blend without it.
STRUCT(QuadraticWeights) {
    float w0;
    float w1;
    float w2;
    float w01;
    float w12;
    float w20;
};

FUNCTION QuadraticWeights quadratic_weights(Barycentric b, float binomial) {
    QuadraticWeights q;
    q.w0 = b.u * b.u;
    q.w1 = b.v * b.v;
    q.w2 = b.w * b.w;
    q.w01 = (b.u * b.v) * binomial;
    q.w12 = (b.v * b.w) * binomial;
    q.w20 = (b.w * b.u) * binomial;
    return q;
}

FUNCTION float blend_quadratic(QuadraticWeights q, float c0, float c1, float c2, float c01, float c12, float c20) {
    const float corners = (q.w0 * c0 + q.w1 * c1) + q.w2 * c2;
    const float edges = (q.w01 * c01 + q.w12 * c12) + q.w20 * c20;
    return corners + edges;
}

FUNCTION Vector evaluate_quadratic(QuadraticWeights q, Vector c0, Vector c1, Vector c2, Vector c01, Vector c12,
                                   Vector c20) {
    return make_vector(blend_quadratic(q, c0.x, c1.x, c2.x, c01.x, c12.x, c20.x),
                       blend_quadratic(q, c0.y, c1.y, c2.y, c01.y, c12.y, c20.y),
                       blend_quadratic(q, c0.z, c1.z, c2.z, c01.z, c12.z, c20.z));
}

STRUCT(CubicWeights) {
    float w0;
    float w1;
    float w2;
    float w01;
    float w10;
    float w12;
    float w21;
    float w20;
    float w02;
    float centre;
};

/// 3 a^2 b, by the role of a and b alone.
FUNCTION float edge_weight(float a, float b) {
    return (3.0f * (a * a)) * b;
}

FUNCTION CubicWeights cubic_weights(Barycentric b) {
    CubicWeights q;
    q.w0 = (b.u * b.u) * b.u;
    q.w1 = (b.v * b.v) * b.v;
    q.w2 = (b.w * b.w) * b.w;
    q.w01 = edge_weight(b.u, b.v);
    q.w10 = edge_weight(b.v, b.u);
    q.w12 = edge_weight(b.v, b.w);
    q.w21 = edge_weight(b.w, b.v);
    q.w20 = edge_weight(b.w, b.u);
    q.w02 = edge_weight(b.u, b.w);
    q.centre = (6.0f * b.u) * (b.v * b.w);
    return q;
}

FUNCTION float blend_cubic(CubicWeights q, float c0, float c1, float c2, float c01, float c10, float c12, float c21,
                           float c20, float c02, float centre) {
    const float at0 = q.w0 * c0 + (q.w01 * c01 + q.w02 * c02);
    const float at1 = q.w1 * c1 + (q.w12 * c12 + q.w10 * c10);
    const float at2 = q.w2 * c2 + (q.w20 * c20 + q.w21 * c21);
    return ((at0 + at1) + at2) + q.centre * centre;
}

FUNCTION Vector evaluate_cubic(CubicWeights q, Vector c0, Vector c1, Vector c2, Vector c01, Vector c10, Vector c12,
                               Vector c21, Vector c20, Vector c02, Vector centre) {
    return make_vector(blend_cubic(q, c0.x, c1.x, c2.x, c01.x, c10.x, c12.x, c21.x, c20.x, c02.x, centre.x),
                       blend_cubic(q, c0.y, c1.y, c2.y, c01.y, c10.y, c12.y, c21.y, c20.y, c02.y, centre.y),
                       blend_cubic(q, c0.z, c1.z, c2.z, c01.z, c10.z, c12.z, c21.z, c20.z, c02.z, centre.z));
}

KERNELS_END

#endif
