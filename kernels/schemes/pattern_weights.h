// The weights of a triangle pattern's points, which a pattern that patches share brings along: the same bits as each
// patch would compute.
#ifndef TESSERA_SCHEMES_PATTERN_WEIGHTS_H
#define TESSERA_SCHEMES_PATTERN_WEIGHTS_H

#include "layout.h"
#include "schemes/basis.h"

KERNELS_BEGIN

/// What cubic Bezier points, quadratic normals and texture coordinates are blended with. PATTERN_WEIGHTS floats.
STRUCT(PatternWeights) {
    Barycentric b;
    QuadraticWeights q;  // the binomial factor left out
    CubicWeights c;
};

FUNCTION PatternWeights pattern_weights(uint u, uint v) {
    PatternWeights w;
    w.b = make_barycentric(u, v);
    w.q = quadratic_weights(w.b, 1.0f);
    w.c = cubic_weights(w.b);
    return w;
}

/// Weight `i` of point k of a run whose weights begin at word `at` of a pattern.
#define PATTERN_WEIGHT(pattern, at, i, k) bits_float(pattern[RUN_AT(at, (i)*PATTERN_RUN + (k))])

#define LOAD_PATTERN_WEIGHTS(w, pattern, at, k)    \
    w.b.u = PATTERN_WEIGHT(pattern, at, 0u, k);    \
    w.b.v = PATTERN_WEIGHT(pattern, at, 1u, k);    \
    w.b.w = PATTERN_WEIGHT(pattern, at, 2u, k);    \
    w.q.w0 = PATTERN_WEIGHT(pattern, at, 3u, k);   \
    w.q.w1 = PATTERN_WEIGHT(pattern, at, 4u, k);   \
    w.q.w2 = PATTERN_WEIGHT(pattern, at, 5u, k);   \
    w.q.w01 = PATTERN_WEIGHT(pattern, at, 6u, k);  \
    w.q.w12 = PATTERN_WEIGHT(pattern, at, 7u, k);  \
    w.q.w20 = PATTERN_WEIGHT(pattern, at, 8u, k);  \
    w.c.w0 = PATTERN_WEIGHT(pattern, at, 9u, k);   \
    w.c.w1 = PATTERN_WEIGHT(pattern, at, 10u, k);  \
    w.c.w2 = PATTERN_WEIGHT(pattern, at, 11u, k);  \
    w.c.w01 = PATTERN_WEIGHT(pattern, at, 12u, k); \
    w.c.w10 = PATTERN_WEIGHT(pattern, at, 13u, k); \
    w.c.w12 = PATTERN_WEIGHT(pattern, at, 14u, k); \
    w.c.w21 = PATTERN_WEIGHT(pattern, at, 15u, k); \
    w.c.w20 = PATTERN_WEIGHT(pattern, at, 16u, k); \
    w.c.w02 = PATTERN_WEIGHT(pattern, at, 17u, k); \
    w.c.centre = PATTERN_WEIGHT(pattern, at, 18u, k)

KERNELS_END

#endif
