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

FUNCTION float blend_guides(float wa, float wb, float wc, float a, float b, float c) {
    return flush_hair((wa * a + wb * b) + wc * c);
}

FUNCTION Vector blend_guide_vectors(float wa, float wb, float wc, Vector a, Vector b, Vector c) {
    return make_vector(blend_guides(wa, wb, wc, a.x, b.x, c.x), blend_guides(wa, wb, wc, a.y, b.y, c.y),
                       blend_guides(wa, wb, wc, a.z, b.z, c.z));
}

FUNCTION HairPoint blend_hair(HairWeights w, HairPoint a, HairPoint b, HairPoint c) {
    const float wa = to_float(w.a) * 0.0000152587890625f;
    const float wb = to_float(w.b) * 0.0000152587890625f;
    const float wc = to_float(w.c) * 0.0000152587890625f;
    HairPoint p;
    p.position = blend_guide_vectors(wa, wb, wc, a.position, b.position, c.position);
    p.tangent = blend_guide_vectors(wa, wb, wc, a.tangent, b.tangent, c.tangent);
    p.normal = blend_guide_vectors(wa, wb, wc, a.normal, b.normal, c.normal);
    p.width = blend_guides(wa, wb, wc, a.width, b.width, c.width);
    return p;
}

KERNELS_END

#endif
