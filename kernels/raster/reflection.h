// Phong's and Blinn's models of reflection, with the constants of the look (raster_layout.h).
#ifndef TESSERA_RASTER_REFLECTION_H
#define TESSERA_RASTER_REFLECTION_H

#include "raster/texture.h"

KERNELS_BEGIN

/// normalise() without branches: it is called many times over, and some drivers (SwiftShader) need memory and time
/// without measure for the branches of the original.
FUNCTION Vector unit_vector(Vector v, Vector fallback) {
    const uint x = float_bits(v.x) & 0x7fffffffu;
    const uint y = float_bits(v.y) & 0x7fffffffu;
    const uint z = float_bits(v.z) & 0x7fffffffu;
    const uint wider = choose_bits(x > y, x, y);
    const uint exponent = choose_bits(wider > z, wider, z) >> 23u;
    const bool is_zero = exponent < 7u;
    const uint safe = choose_bits(is_zero, 127u, choose_bits(exponent > 253u, 127u, exponent));
    const float s = choose(is_zero, 0.0f, bits_float((254u - safe) << 23u));
    const Vector n = flush_vector(scale(v, s));
    const float squared = dot_product(n, n);
    const bool some = squared > 0.0f;
    const Vector unit = flush_vector(scale(n, exact_rsqrt_of_normal(choose(some, squared, 1.0f))));
    return make_vector(choose(some, unit.x, fallback.x), choose(some, unit.y, fallback.y),
                       choose(some, unit.z, fallback.z));
}

STRUCT(Reflection) {
    float ambient;
    float diffuse;
    float specular;
    float shininess;
    bool half_vector;
};

/// From model space to camera space, of a direction.
FUNCTION Vector turn_to_camera(DrawParams p, Vector v) {
    return flush_vector(make_vector(((p.rx * v.x + p.ry * v.y) + p.rz * v.z) * p.unscale,
                                    ((p.ux * v.x + p.uy * v.y) + p.uz * v.z) * p.unscale,
                                    ((p.bx * v.x + p.by * v.y) + p.bz * v.z) * p.unscale));
}

/// A colour under light that it takes on, and light that it throws back as it is.
FUNCTION Colour lit_colour(Colour base, float body, float white) {
    Colour c;
    c.red = base.red * body + white;
    c.green = base.green * body + white;
    c.blue = base.blue * body + white;
    c.alpha = base.alpha;
    return c;
}

/// From a point in camera space to the light.
FUNCTION Vector towards_light(DrawParams p, Vector camera, Vector light, bool is_place) {
    const Vector ahead = make_vector(0.0f, 0.0f, 1.0f);
    const float from = choose(is_place, 1.0f, 0.0f);
    return unit_vector(make_vector(light.x + from * (p.rt - camera.x), light.y + from * (p.ut - camera.y),
                                   light.z + from * (p.bt - camera.z)),
                       ahead);
}

/// Blinn, "Models of light reflection for computer synthesized pictures", 1977; Phong, "Illumination for computer
/// generated pictures", 1975. Vectors are unit and point away from the surface.
FUNCTION Colour reflect_light(Reflection r, Vector n, Vector to_light, Vector to_eye, Colour base) {
    const float facing = dot_product(n, to_light);
    const float lit = at_least(facing, 0.0f);
    const Vector halfway = unit_vector(add(to_light, to_eye), to_eye);
    const Vector mirrored = subtract(scale(n, 2.0f * facing), to_light);
    const float high = choose(r.half_vector, dot_product(n, halfway), dot_product(mirrored, to_eye));
    const float peak = exact_power(at_most(at_least(high, 0.0f), 1.0f), r.shininess);
    const float white = r.specular * choose(lit > 0.0f, peak, 0.0f);
    const float body = r.ambient + r.diffuse * lit;
    return lit_colour(base, body, white);
}

KERNELS_END

#define LOOK_FLOAT(texels, at) bits_float(texels[at])
#define LOOK_VECTOR(texels, at) \
    make_vector(bits_float(texels[at]), bits_float(texels[(at) + 1u]), bits_float(texels[(at) + 2u]))

// A step of shading (shading.h), after SHADE_NORMAL.
#define SHADE_REFLECTION(colour, p)                                                                                   \
    Reflection reflection;                                                                                            \
    reflection.ambient = LOOK_FLOAT(texels, LOOK_REFLECTION);                                                         \
    reflection.diffuse = LOOK_FLOAT(texels, LOOK_REFLECTION + 1u);                                                    \
    reflection.specular = LOOK_FLOAT(texels, LOOK_REFLECTION + 2u);                                                   \
    reflection.shininess = LOOK_FLOAT(texels, LOOK_SHININESS);                                                        \
    reflection.half_vector = texels[LOOK_HALF_VECTOR] != 0u;                                                          \
    const bool own_colour = texels[LOOK_HAS_COLOUR] == 0u;                                                            \
    base.red = choose(own_colour, base.red, LOOK_FLOAT(texels, LOOK_COLOUR));                                         \
    base.green = choose(own_colour, base.green, LOOK_FLOAT(texels, LOOK_COLOUR + 1u));                                \
    base.blue = choose(own_colour, base.blue, LOOK_FLOAT(texels, LOOK_COLOUR + 2u));                                  \
    const Vector camera = weigh_vectors(inside, ca.camera, cb.camera, cc.camera);                                     \
    const Vector lamp = towards_light(p, camera, LOOK_VECTOR(texels, LOOK_LIGHT), texels[LOOK_LIGHT_IS_PLACE] != 0u); \
    const Vector eye = unit_vector(make_vector(-camera.x, -camera.y, -camera.z), make_vector(0.0f, 0.0f, 1.0f));      \
    colour = reflect_light(reflection, turn_to_camera(p, normal), lamp, eye, base);

#endif
