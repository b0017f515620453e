// The metallic-roughness model of glTF 2.0 (appendix B) under the lights of the file and the light of a sky.
//
// Direct light: GGX with the height-correlated Smith term (Heitz, "Understanding the masking-shadowing function in
// microfacet-based BRDFs", 2014), Schlick's Fresnel term, Lambert below. The sky: three colours blended by height,
// wider the rougher the surface is, with Karis' fit of the split sum's second factor ("Physically based shading on
// mobile", 2014).
#ifndef TESSERA_RASTER_PBR_H
#define TESSERA_RASTER_PBR_H

#include "raster/maps.h"

KERNELS_BEGIN

#define ONE_OVER_PI 0.31830987f
#define LEAST_ROUGHNESS 0.045f  // under it, highlights are narrower than single precision

/// 0 for x under 2^-60.
FUNCTION float square_root(float x) {
    const bool none = x < 8.673617379884035e-19f;
    const float sound = choose(none, 1.0f, x);
    return choose(none, 0.0f, sound * exact_rsqrt_of_normal(sound));
}

/// a / b for b in [2^-60, 2^60], within 5 ULP, without the branches of exact_divide.
FUNCTION float positive_quotient(float a, float b) {
    const float r = exact_rsqrt_of_normal(b);
    return a * (r * r);
}

FUNCTION Vector blend_vectors(Vector a, Vector b, float t) {
    return make_vector(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z));
}

FUNCTION Vector multiply(Vector a, Vector b) {
    return make_vector(flush_tiny(a.x * b.x), flush_tiny(a.y * b.y), flush_tiny(a.z * b.z));
}

/// (1 - x)^5: Schlick, "An inexpensive BRDF model for physically-based rendering", 1994.
FUNCTION float schlick(float x) {
    const float y = 1.0f - x;
    return flush_tiny(flushed_square(flushed_square(y)) * y);
}

/// The part of a light that leaves towards the eye, for a light of intensity 1. Vectors are unit, in camera space.
FUNCTION Vector reflected_share(Vector n, Vector to_light, Vector to_eye, float n_eye, Vector body, Vector f0,
                                float alpha) {
    const Vector halfway = unit_vector(add(to_light, to_eye), n);
    const float n_light = unit_clamp(dot_product(n, to_light));
    const float n_half = unit_clamp(dot_product(n, halfway));
    const float fresnel = schlick(unit_clamp(dot_product(to_eye, halfway)));
    const float a2 = alpha * alpha;
    const float f = (n_half * a2 - n_half) * n_half + 1.0f;
    const float smith = n_light * square_root(flushed_square(n_eye) * (1.0f - a2) + a2) +
                        n_eye * square_root(flushed_square(n_light) * (1.0f - a2) + a2);
    const float lobe = positive_quotient(0.5f * a2 * n_light, 3.14159274f * (f * f) * at_least(smith, 1e-7f));
    const Vector mirror = blend_vectors(f0, make_vector(1.0f, 1.0f, 1.0f), fresnel);
    const float below = ONE_OVER_PI * n_light;
    return make_vector(mirror.x * lobe + (1.0f - mirror.x) * (body.x * below),
                       mirror.y * lobe + (1.0f - mirror.y) * (body.y * below),
                       mirror.z * lobe + (1.0f - mirror.z) * (body.z * below));
}

/// The sky's light from directions about one whose height (sine of its elevation) is `height`.
FUNCTION Vector sky_light(Vector zenith, Vector horizon, Vector ground, float height, float roughness) {
    const float width = 0.06f + 0.94f * roughness;
    const float t = unit_clamp(0.5f + 0.5f * positive_quotient(height, width));
    const float above = (t * t) * (3.0f - 2.0f * t);
    return blend_vectors(ground, blend_vectors(horizon, zenith, unit_clamp(height)), flush_tiny(above));
}

/// Components under 2^-40 are zero, so that no difference of products becomes a denormal; those that no tangent or
/// normal has are zero too.
FUNCTION float frame_component(float x) {
    return choose(is_below(x, 131u), choose(is_below(x, 87u), 0.0f, x), 0.0f);
}

FUNCTION Vector frame_vector(Vector v) {
    return make_vector(frame_component(v.x), frame_component(v.y), frame_component(v.z));
}

/// The normal that a normal map says, in a frame of interpolated normal and tangent as MikkTSpace decodes: neither of
/// unit length nor at right angles. `plain` stands in for a sum without length; it is the normal where there is no
/// tangent either.
FUNCTION Vector bumped_normal(Vector bump, Vector normal, Vector tangent, float handedness, Vector plain) {
    const Vector n = frame_vector(normal);
    const Vector t = frame_vector(tangent);
    const Vector b = frame_vector(scale(cross_product(n, t), choose(handedness < 0.0f, -1.0f, 1.0f)));
    const float x = choose(is_below(bump.x, 97u), 0.0f, bump.x);
    const float y = choose(is_below(bump.y, 97u), 0.0f, bump.y);
    const float z = at_least(bump.z, 0.0f);
    const Vector sum = add(add(scale(t, x), scale(b, y)), scale(n, choose(is_below(z, 97u), 0.0f, z)));
    return unit_vector(flush_vector(sum), plain);
}

/// Narkowicz, "ACES filmic tone mapping curve", 2015: x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14).
FUNCTION float tone_aces(float light) {
    const float x = at_most(at_least(light, 0.0f), 1024.0f);
    return positive_quotient(x * (2.51f * x + 0.03f), x * (2.43f * x + 0.59f) + 0.14f);
}

FUNCTION float toned(float light, float exposure, uint curve) {
    const float x = flush_tiny(light * exposure);
    return choose(curve == TONE_ACES, tone_aces(x), x);
}

KERNELS_END

// A step of shading (shading.h), after SHADE_NORMAL: declares the frame of normal maps, in camera space. On the side
// that is seen from behind all its vectors are turned round, so that the cross product has to be turned once more.
#define SHADE_TANGENT(p, triangle, back)                                                                             \
    const uint at_a = VERTEX_ATTRIBUTES(p, (triangle)*3u);                                                           \
    const uint at_b = VERTEX_ATTRIBUTES(p, (triangle)*3u + 1u);                                                      \
    const uint at_c = VERTEX_ATTRIBUTES(p, (triangle)*3u + 2u);                                                      \
    const Vector model_tangent = weigh_vectors(inside, frame_vector(LOAD_VECTOR(attributes, at_a + 4u)),             \
                                               frame_vector(LOAD_VECTOR(attributes, at_b + 4u)),                     \
                                               frame_vector(LOAD_VECTOR(attributes, at_c + 4u)));                    \
    const float visible_side = choose(back, -1.0f, 1.0f);                                                            \
    const float handedness =                                                                                         \
        visible_side * weigh(inside, frame_component(attributes[at_a + 7u]), frame_component(attributes[at_b + 7u]), \
                             frame_component(attributes[at_c + 7u]));                                                \
    const Vector frame_normal = turn_to_camera(p, scale(model_normal, visible_side));                                \
    const Vector frame_tangent = turn_to_camera(p, scale(model_tangent, visible_side));

// Steps of shading, after SHADE_MAPS, SHADE_NORMAL and SHADE_TANGENT.
#define SHADE_PBR_LIGHT(colour, p)                                                                                    \
    const Vector camera = weigh_vectors(inside, ca.camera, cb.camera, cc.camera);                                     \
    const Vector to_eye = unit_vector(make_vector(-camera.x, -camera.y, -camera.z), make_vector(0.0f, 0.0f, 1.0f));   \
    const Vector n = bumped_normal(surface.bump, frame_normal, frame_tangent, handedness, turn_to_camera(p, normal)); \
    const float n_eye = at_most(at_least(dot_product(n, to_eye), 1e-4f), 1.0f);                                       \
    const float roughness = at_most(at_least(surface.roughness, LEAST_ROUGHNESS), 1.0f);                              \
    const float alpha = roughness * roughness;                                                                        \
    const float metallic = unit_clamp(surface.metallic);                                                              \
    const Vector paint = make_vector(surface.base.red, surface.base.green, surface.base.blue);                        \
    const Vector f0 = blend_vectors(make_vector(0.04f, 0.04f, 0.04f), paint, metallic);                               \
    const Vector body = flush_vector(scale(paint, 1.0f - metallic));                                                  \
    const Vector zenith = LOOK_VECTOR(texels, LOOK_ZENITH);                                                           \
    const Vector horizon = LOOK_VECTOR(texels, LOOK_HORIZON);                                                         \
    const Vector ground = LOOK_VECTOR(texels, LOOK_GROUND);                                                           \
    const Vector up = turn_to_camera(p, make_vector(0.0f, 1.0f, 0.0f));                                               \
    const float up_eye = dot_product(up, to_eye);                                                                     \
    const float up_n = dot_product(up, n);                                                                            \
    const float up_mirror = 2.0f * dot_product(n, to_eye) * up_n - up_eye;                                            \
    const Vector spread = sky_light(zenith, horizon, ground, up_n, 1.0f);                                             \
    const Vector mirror = sky_light(zenith, horizon, ground, up_mirror, roughness);                                   \
    const float karis_x = 1.0f - roughness;                                                                           \
    const float karis_y = 0.0425f - 0.0275f * roughness;                                                              \
    const float karis_a = at_most(karis_x * karis_x, exact_exp2(-9.28f * n_eye)) * karis_x + karis_y;                 \
    const float karis_scale = -1.04f * karis_a + (1.04f - 0.572f * roughness);                                        \
    const float karis_bias = 1.04f * karis_a + (0.022f * roughness - 0.04f);                                          \
    const Vector sheen = make_vector(f0.x * karis_scale + karis_bias, f0.y * karis_scale + karis_bias,                \
                                     f0.z * karis_scale + karis_bias);                                                \
    const Vector from_sky = add(multiply(sheen, mirror), multiply(body, spread));                                     \
    Vector light = add(scale(from_sky, surface.occlusion), surface.emissive);                                         \
    const uint lights = texels[LOOK_LIGHTS];                                                                          \
    for (uint i = 0u; i < lights; ++i) {                                                                              \
        const uint at = LIGHTS_AT + i * LIGHT_WORDS;                                                                  \
        const uint kind = texels[at];                                                                                 \
        const bool fixed_to_eye = texels[at + 1u] != 0u;                                                              \
        const Vector place = LOOK_VECTOR(texels, at + LIGHT_PLACE);                                                   \
        const Vector turned = turn_to_camera(p, place);                                                               \
        const Vector seen = make_vector(clip_row(p.rx, p.ry, p.rz, p.rt, place.x, place.y, place.z),                  \
                                        clip_row(p.ux, p.uy, p.uz, p.ut, place.x, place.y, place.z),                  \
                                        clip_row(p.bx, p.by, p.bz, p.bt, place.x, place.y, place.z));                 \
        const Vector away = flush_vector(scale(subtract(seen, camera), p.unscale));                                   \
        const bool far = kind == LIGHT_DIRECTIONAL;                                                                   \
        const Vector ray = make_vector(choose(far, choose(fixed_to_eye, place.x, turned.x), away.x),                  \
                                       choose(far, choose(fixed_to_eye, place.y, turned.y), away.y),                  \
                                       choose(far, choose(fixed_to_eye, place.z, turned.z), away.z));                 \
        const Vector to_light = unit_vector(ray, n);                                                                  \
        const float squared = at_most(at_least(flush_tiny(dot_product(away, away)), 1e-12f), 1e17f);                  \
        const float reach = flush_tiny(squared * flushed_square(LOOK_FLOAT(texels, at + LIGHT_RANGE)));               \
        const float window = unit_clamp(1.0f - flushed_square(reach));                                                \
        const Vector aim = turn_to_camera(p, LOOK_VECTOR(texels, at + LIGHT_SPOT));                                   \
        const float inner = unit_clamp(-dot_product(aim, to_light) * LOOK_FLOAT(texels, at + LIGHT_CONE) +            \
                                       LOOK_FLOAT(texels, at + LIGHT_CONE + 1u));                                     \
        const float cone = choose(kind == LIGHT_SPOTTED, flushed_square(inner), 1.0f);                                \
        const float faded = choose(far, 1.0f, flush_tiny((window * cone) * positive_quotient(1.0f, squared)));        \
        const Vector share = flush_vector(reflected_share(n, to_light, to_eye, n_eye, body, f0, alpha));              \
        const Vector intensity = flush_vector(scale(LOOK_VECTOR(texels, at + LIGHT_COLOUR), faded));                  \
        light = add(light, multiply(share, intensity));                                                               \
    }                                                                                                                 \
    const bool unlit = texels[LOOK_UNLIT] != 0u;                                                                      \
    const float exposure = LOOK_FLOAT(texels, LOOK_EXPOSURE);                                                         \
    const uint curve = texels[LOOK_TONE_CURVE];                                                                       \
    colour.red = unit_clamp(choose(unlit, paint.x, toned(light.x, exposure, curve)));                                 \
    colour.green = unit_clamp(choose(unlit, paint.y, toned(light.y, exposure, curve)));                               \
    colour.blue = unit_clamp(choose(unlit, paint.z, toned(light.z, exposure, curve)));                                \
    colour.alpha = base.alpha;

#define SHADE_PBR(colour, p) \
    SHADE_MAPS(p)            \
    base = surface.base;     \
    SHADE_PBR_LIGHT(colour, p)

// As SHADE of shading.h.
#define SHADE_PBR_IN_ORDER(colour, dropped, p, triangle, back, px, py) \
    {                                                                  \
        SHADE_CORNERS(p, triangle, px, py)                             \
        SHADE_INSIDE                                                   \
        SHADE_VERTEX_COLOUR(p, triangle)                               \
        SHADE_MAPS(p)                                                  \
        base = surface.base;                                           \
        SHADE_ALPHA(dropped, p)                                        \
        SHADE_NORMAL(p, back)                                          \
        SHADE_TANGENT(p, triangle, back)                               \
        SHADE_PBR_LIGHT(colour, p)                                     \
        SHADE_OVER(colour, p)                                          \
    }

#endif
