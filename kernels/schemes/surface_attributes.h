// Colours and tangents of a vertex, blended from those of a patch's corners.
#ifndef TESSERA_SCHEMES_SURFACE_ATTRIBUTES_H
#define TESSERA_SCHEMES_SURFACE_ATTRIBUTES_H

#include "layout.h"
#include "schemes/basis.h"
#include "schemes/quad_basis.h"

KERNELS_BEGIN

STRUCT(SurfaceAttributes) {
    Vector colour;
    float alpha;
    Vector tangent;
    float handedness;
};

/// A blend of unit tangents made unit, as normals are, so that a normal map tilts a curved surface no less between the
/// corners; zero where they cancel and where there are none. The handedness of a blend is its sign.
FUNCTION SurfaceAttributes make_surface_attributes(Vector colour, float alpha, Vector tangent, float handedness) {
    const Vector t = flush_vector(tangent);  // squares are 0 or at least 2^-120 now
    const float length_squared = dot_product(t, t);
    const bool some = length_squared > 0.0f;
    const Vector unit = scale(t, exact_rsqrt_of_normal(some ? length_squared : 1.0f));
    const float positive = handedness > 0.0f ? 1.0f : 0.0f;
    const float negative = handedness < 0.0f ? 1.0f : 0.0f;
    SurfaceAttributes a;
    a.colour = flush_vector(colour);
    a.alpha = flush_tiny(alpha);
    a.tangent = make_vector(some ? unit.x : 0.0f, some ? unit.y : 0.0f, some ? unit.z : 0.0f);
    a.handedness = positive - negative;
    return a;
}

#define LOAD_ATTRIBUTES(a, buffer, at)          \
    a.colour = LOAD_VECTOR(buffer, at);         \
    a.alpha = buffer[(at) + 3u];                \
    a.tangent = LOAD_VECTOR(buffer, (at) + 4u); \
    a.handedness = buffer[(at) + 7u]

/// As vertex k of an array that holds RUN of each word.
#define PUT_ATTRIBUTES_INTO_RUN(run, k, a) \
    run[k] = (a).colour.x;                 \
    run[RUN + (k)] = (a).colour.y;         \
    run[2u * RUN + (k)] = (a).colour.z;    \
    run[3u * RUN + (k)] = (a).alpha;       \
    run[4u * RUN + (k)] = (a).tangent.x;   \
    run[5u * RUN + (k)] = (a).tangent.y;   \
    run[6u * RUN + (k)] = (a).tangent.z;   \
    run[7u * RUN + (k)] = (a).handedness

FUNCTION SurfaceAttributes blend_triangle_attributes(SurfaceAttributes a, SurfaceAttributes b, SurfaceAttributes c,
                                                     uint u, uint v) {
    const Barycentric w = make_barycentric(u, v);
    return make_surface_attributes(
        evaluate_linear(w, a.colour, b.colour, c.colour), blend_linear(w, a.alpha, b.alpha, c.alpha),
        evaluate_linear(w, a.tangent, b.tangent, c.tangent), blend_linear(w, a.handedness, b.handedness, c.handedness));
}

FUNCTION SurfaceAttributes blend_quad_attributes(SurfaceAttributes a, SurfaceAttributes b, SurfaceAttributes c,
                                                 SurfaceAttributes d, uint u, uint v) {
    const CurveWeights by_u = curve_weights_linear(u);
    const CurveWeights by_v = curve_weights_linear(v);
    return make_surface_attributes(evaluate_bilinear(by_u, by_v, a.colour, b.colour, c.colour, d.colour),
                                   blend_bilinear(by_u, by_v, a.alpha, b.alpha, c.alpha, d.alpha),
                                   evaluate_bilinear(by_u, by_v, a.tangent, b.tangent, c.tangent, d.tangent),
                                   blend_bilinear(by_u, by_v, a.handedness, b.handedness, c.handedness, d.handedness));
}

KERNELS_END

#endif
