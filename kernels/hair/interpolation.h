// Hairs between guides: which weights a hair gives to the guides of its patch, and the blend of their points. Integer
// arithmetic alone decides where a hair grows; weights add up to exactly 1.
#ifndef TESSERA_HAIR_INTERPOLATION_H
#define TESSERA_HAIR_INTERPOLATION_H

#include "hair/guide_curve.h"
#include "tessellator/edge.h"

KERNELS_BEGIN

/// Weights of the three guides of a patch, 16.16.
STRUCT(HairWeights) {
    uint a;
    uint b;
    uint c;
};

/// Weights of hair `number` of `total` between `guides` guides. Between two, hairs lie evenly from the first guide on,
/// the second one excluded, as isolines do. Between three, they follow a sequence that fills the triangle evenly
/// however many there are: multiples of the powers of the plastic number's inverse, modulo 1 (Roberts, The unreasonable
/// effectiveness of quasirandom sequences, 2018), begun at `seed` and folded into the triangle.
FUNCTION HairWeights hair_weights(uint guides, uint number, uint total, uint seed) {
    const uint x = (seed + number * 3242174889u) >> 16u;
    const uint y = (seed * 2654435769u + number * 2447445414u) >> 16u;
    const bool outside = x + y > 65536u;
    const uint s = outside ? 65536u - x : x;
    const uint t = outside ? 65536u - y : y;
    const uint between = even_coordinate(number < total ? number : total, total);
    HairWeights w;
    w.b = guides == 3u ? s : (guides == 2u ? between : 0u);
    w.c = guides == 3u ? t : 0u;
    w.a = 65536u - w.b - w.c;
    return w;
}

/// By how much a hair ends before its guides do, as a share of their length in 16.16: a number of its own below
/// `shorter`.
FUNCTION uint hair_cut(uint number, uint seed, uint shorter) {
    uint h = seed ^ (number * 2654435769u);
    h = (h ^ (h >> 15u)) * 739982445u;
    h = (h ^ (h >> 12u)) * 695872825u;
    return ((h >> 16u) * shorter) >> 16u;
}

FUNCTION HairPoint no_hair_point() {
    HairPoint p;
    p.position = make_vector(0.0f, 0.0f, 0.0f);
    p.tangent = make_vector(0.0f, 0.0f, 0.0f);
    p.normal = make_vector(0.0f, 0.0f, 0.0f);
    p.width = 0.0f;
    return p;
}

FUNCTION Vector add_weighted_vector(Vector sum, Vector v, float weight) {
    return flush_hair_vector(add(sum, scale(v, weight)));
}

/// Adds a guide's share to a hair. The first share of 1 is the guide itself, to the bit.
FUNCTION HairPoint add_guide(HairPoint sum, HairPoint guide, uint weight) {
    const float w = to_float(weight) * 0.0000152587890625f;
    HairPoint p;
    p.position = add_weighted_vector(sum.position, guide.position, w);
    p.tangent = add_weighted_vector(sum.tangent, guide.tangent, w);
    p.normal = add_weighted_vector(sum.normal, guide.normal, w);
    p.width = flush_hair(sum.width + w * guide.width);
    return p;
}

KERNELS_END

#endif
