// The colour of a triangle in a pixel: what the present materials have, base colour and texture under Phong's light.
//
// Richer materials replace this file and the kernels made of it (shade_kernel.h), nothing else. What they get is the
// interface of the visibility buffer: a triangle of the draw and the side that is seen, for a pixel of the image. From
// these they have, by interpolation.h, the corners with all their attributes, perspective-correct weights at the
// pixel's middle (weights_inside keeps them in the triangle) and the change of the weights to the neighbours:
// derivatives of any attribute, for footprints of textures, tangent frames and lines of even width. Everything of the
// draw comes in DrawParams, one material each; textures lie in `texels` (raster_layout.h). The result is light
// multiplied by alpha.
#ifndef TESSERA_RASTER_SHADING_H
#define TESSERA_RASTER_SHADING_H

#include "raster/reflection.h"
#include "raster/srgb.h"

KERNELS_BEGIN

// The light and the reflection constants are those of the Vulkan rasteriser (raster_mesh.frag): van Veen and Baakman,
// "Curved PN triangles on the GPU", figure 14; their exponent of 150 for Phong's reflected ray is 600 for Blinn's half
// vector.
#define LIGHT_AMBIENT 0.4f
#define LIGHT_DIFFUSE 0.5f
#define LIGHT_SPECULAR 0.3f

/// normalize(-0.5, 0.7, 1), in camera space.
FUNCTION Vector to_light(void) {
    return make_vector(-0.379049021f, 0.530668616f, 0.758098043f);
}

FUNCTION float flushed_square(float x) {
    return flush_tiny(x * x);
}

FUNCTION float unit_clamp(float x) {
    return at_most(at_least(x, 0.0f), 1.0f);
}

/// The blend of three shares of a colour, each brought into [0, 1]; exactly theirs where they are equal. Shares under
/// 2^-20 are zero, so that no difference of products becomes a denormal.
FUNCTION float blend_shares(Weights w, float a, float b, float c) {
    const float x = choose(is_below(a, 107u), 0.0f, unit_clamp(a));
    const float y = choose(is_below(b, 107u), 0.0f, unit_clamp(b));
    const float z = choose(is_below(c, 107u), 0.0f, unit_clamp(c));
    return unit_clamp(x + (w.b * (y - x) + w.c * (z - x)));
}

/// x^600 for x in [0, 1]; under 2^-60 it is 0.
FUNCTION float power_600(float x) {
    const float x8 = flushed_square(flushed_square(flushed_square(flush_tiny(x))));
    const float x16 = flushed_square(x8);
    const float x64 = flushed_square(flushed_square(x16));
    const float x512 = flushed_square(flushed_square(flushed_square(x64)));
    return flush_tiny(flush_tiny(x8 * x16) * flush_tiny(x64 * x512));
}

/// The unit normal on the visible side, in the model's axes. A normal without length faces the viewer.
FUNCTION Vector facing_normal(DrawParams p, Vector normal, bool back) {
    const Vector to_viewer = make_vector(p.bx * p.unscale, p.by * p.unscale, p.bz * p.unscale);
    const Vector n = unit_vector(normal, make_vector(0.0f, 0.0f, 0.0f));
    const bool none = !(dot_product(n, n) > 0.0f);
    const float side = choose(back, -1.0f, 1.0f);
    return make_vector(choose(none, to_viewer.x, n.x * side), choose(none, to_viewer.y, n.y * side),
                       choose(none, to_viewer.z, n.z * side));
}

FUNCTION Colour phong_light(DrawParams p, Vector normal, Vector camera, Colour base) {
    const Vector n = turn_to_camera(p, normal);
    const Vector ahead = make_vector(0.0f, 0.0f, 1.0f);
    const Vector to_eye = unit_vector(make_vector(-camera.x, -camera.y, -camera.z), ahead);
    const Vector halfway = unit_vector(add(to_light(), to_eye), ahead);
    const float lit = at_least(dot_product(n, to_light()), 0.0f);
    const float high = at_most(at_least(dot_product(n, halfway), 0.0f), 1.0f);
    const float shine = choose(lit > 0.0f, power_600(high), 0.0f);
    const float body = LIGHT_AMBIENT + LIGHT_DIFFUSE * lit;
    const float white = LIGHT_SPECULAR * shine;
    return lit_colour(base, body, white);
}

/// Distance to the edge opposite a corner, in pixels.
FUNCTION float edge_distance(float weight, float across, float down) {
    const float squared = flush_tiny(flushed_square(across) + flushed_square(down));
    return weight * exact_rsqrt(at_least(squared, 1e-16f));
}

/// 0 on the triangle's edges, 1 beside them: lines 1.5 pixels wide.
FUNCTION float beside_edges(Weights w, Weights across, Weights down) {
    const float a = edge_distance(w.a, across.a, down.a);
    const float b = edge_distance(w.b, across.b, down.b);
    const float c = edge_distance(w.c, across.c, down.c);
    const float nearest = at_most(at_most(a, b), c);
    const float t = at_most(at_least(nearest - 0.25f, 0.0f), 1.0f);
    return (t * t) * (3.0f - 2.0f * t);
}

/// An opaque colour.
FUNCTION Colour make_colour(float red, float green, float blue) {
    Colour c;
    c.red = red;
    c.green = green;
    c.blue = blue;
    c.alpha = 1.0f;
    return c;
}

/// Dark lines on a light fill.
FUNCTION Colour wire_colour(Weights w, Weights across, Weights down, float alpha) {
    const float s = beside_edges(w, across, down);
    Colour colour;
    colour.red = 0.02f + s * 0.78f;
    colour.green = 0.05f + s * 0.77f;
    colour.blue = 0.12f + s * 0.73f;
    colour.alpha = alpha;
    return colour;
}

/// Dark lines over a colour.
FUNCTION Colour wires_over(Colour colour, float beside) {
    Colour c;
    c.red = 0.02f + beside * (colour.red - 0.02f);
    c.green = 0.05f + beside * (colour.green - 0.05f);
    c.blue = 0.12f + beside * (colour.blue - 0.12f);
    c.alpha = colour.alpha;
    return c;
}

KERNELS_END

// Signed indices, of which compilers know that they do not wrap around: CPUs gather by 32 bits then.
#define VERTEX_WORD(vertex, word) vertices[to_int(vertex) * 8 + (word)]
#define LOAD_CORNER(p, vertex)                                                                          \
    make_corner(p, make_vector(VERTEX_WORD(vertex, 0), VERTEX_WORD(vertex, 1), VERTEX_WORD(vertex, 2)), \
                make_vector(VERTEX_WORD(vertex, 3), VERTEX_WORD(vertex, 4), VERTEX_WORD(vertex, 5)),    \
                VERTEX_WORD(vertex, 6), VERTEX_WORD(vertex, 7))

// The steps of shading a triangle in the pixel (px, py) of the image, as macros because they read the buffers vertices,
// indices, attributes and texels. Each declares what later ones use.
#define SHADE_CORNERS(p, triangle, px, py)                                                         \
    const Corner ca = LOAD_CORNER(p, DRAW_VERTEX(p, to_int(triangle) * 3));                        \
    const Corner cb = LOAD_CORNER(p, DRAW_VERTEX(p, to_int(triangle) * 3 + 1));                    \
    const Corner cc = LOAD_CORNER(p, DRAW_VERTEX(p, to_int(triangle) * 3 + 2));                    \
    const Weights weights = pixel_weights(p, ca, cb, cc, px, py);                                  \
    const Weights across = subtract_weights(pixel_weights(p, ca, cb, cc, (px) + 1u, py), weights); \
    const Weights down = subtract_weights(pixel_weights(p, ca, cb, cc, px, (py) + 1u), weights);   \
    Colour base;                                                                                   \
    base.red = p.red;                                                                              \
    base.green = p.green;                                                                          \
    base.blue = p.blue;                                                                            \
    base.alpha = p.alpha;

#define SHADE_INSIDE const Weights inside = weights_inside(weights, across, down);

// Multiplies `base` by the colours of the vertices.
#define VERTEX_ATTRIBUTES(p, i) (DRAW_VERTEX(p, i) * (p).attribute_stride)
#define SHADE_VERTEX_COLOUR(p, triangle)                                                                    \
    {                                                                                                       \
        const uint at_a = VERTEX_ATTRIBUTES(p, (triangle)*3u);                                              \
        const uint at_b = VERTEX_ATTRIBUTES(p, (triangle)*3u + 1u);                                         \
        const uint at_c = VERTEX_ATTRIBUTES(p, (triangle)*3u + 2u);                                         \
        const float red_share = blend_shares(inside, attributes[at_a], attributes[at_b], attributes[at_c]); \
        const float green_share =                                                                           \
            blend_shares(inside, attributes[at_a + 1u], attributes[at_b + 1u], attributes[at_c + 1u]);      \
        const float blue_share =                                                                            \
            blend_shares(inside, attributes[at_a + 2u], attributes[at_b + 2u], attributes[at_c + 2u]);      \
        const float alpha_share =                                                                           \
            blend_shares(inside, attributes[at_a + 3u], attributes[at_b + 3u], attributes[at_c + 3u]);      \
        base.red = flush_tiny(base.red) * red_share;                                                        \
        base.green = flush_tiny(base.green) * green_share;                                                  \
        base.blue = flush_tiny(base.blue) * blue_share;                                                     \
        base.alpha = flush_tiny(base.alpha) * alpha_share;                                                  \
    }

// Multiplies `base` by the texture. The next level is read even where it has no weight: a branch would cost more.
#define SHADE_TEXTURE(p)                                                             \
    const float level = texture_level(p, across, down, ca, cb, cc);                  \
    const uint whole = to_uint(floor_to_int(level));                                 \
    const uint next = choose_bits(whole + 1u < p.texture_levels, whole + 1u, whole); \
    const float part = level - to_float(whole);                                      \
    const float u = weigh(inside, ca.u, cb.u, cc.u);                                 \
    const float v = weigh(inside, ca.v, cb.v, cc.v);                                 \
    Colour texture_colour;                                                           \
    texture_colour.red = 0.0f;                                                       \
    texture_colour.green = 0.0f;                                                     \
    texture_colour.blue = 0.0f;                                                      \
    texture_colour.alpha = 0.0f;                                                     \
    ADD_LEVEL(texture_colour, texels, p, whole, u, v, (1.0f - part))                 \
    ADD_LEVEL(texture_colour, texels, p, next, u, v, part)                           \
    base.red = base.red * texture_colour.red;                                        \
    base.green = base.green * texture_colour.green;                                  \
    base.blue = base.blue * texture_colour.blue;                                     \
    base.alpha = base.alpha * texture_colour.alpha;

#define SHADE_NORMAL(p, back)                                                           \
    const Vector model_normal = weigh_vectors(inside, ca.normal, cb.normal, cc.normal); \
    const Vector normal = facing_normal(p, model_normal, back);

#define SHADE_PHONG(colour, p)                                                    \
    const Vector camera = weigh_vectors(inside, ca.camera, cb.camera, cc.camera); \
    colour = phong_light(p, normal, camera, base);

// The codes of the picture are the normal.
#define SHADE_NORMAL_AS_COLOUR(colour)                                                    \
    colour.red = SRGB_DECODE(texels, round_to_code((normal.x * 0.5f + 0.5f) * 255.0f));   \
    colour.green = SRGB_DECODE(texels, round_to_code((normal.y * 0.5f + 0.5f) * 255.0f)); \
    colour.blue = SRGB_DECODE(texels, round_to_code((normal.z * 0.5f + 0.5f) * 255.0f));  \
    colour.alpha = base.alpha;

// Codes of 255 for the nearest distance down to 0 for the farthest.
#define SHADE_DEPTH_AS_COLOUR(colour)                                                            \
    const float distance_ahead = -weigh(inside, ca.camera.z, cb.camera.z, cc.camera.z);          \
    const float share_of_range =                                                                 \
        (distance_ahead - LOOK_FLOAT(texels, LOOK_DEPTH)) * LOOK_FLOAT(texels, LOOK_DEPTH + 1u); \
    colour.red = SRGB_DECODE(texels, round_to_code(255.0f * (1.0f - share_of_range)));           \
    colour.green = colour.red;                                                                   \
    colour.blue = colour.red;                                                                    \
    colour.alpha = base.alpha;

// Codes are the fractions of u and v; blue marks every other unit square, as a chessboard.
#define SHADE_UV_AS_COLOUR(colour)                                                            \
    const float shown_u = weigh(inside, ca.u, cb.u, cc.u);                                    \
    const float shown_v = weigh(inside, ca.v, cb.v, cc.v);                                    \
    const int unit_u = floor_to_int(shown_u);                                                 \
    const int unit_v = floor_to_int(shown_v);                                                 \
    colour.red = SRGB_DECODE(texels, round_to_code(255.0f * (shown_u - to_float(unit_u))));   \
    colour.green = SRGB_DECODE(texels, round_to_code(255.0f * (shown_v - to_float(unit_v)))); \
    colour.blue = choose(((unit_u + unit_v) & 1) != 0, 0.25f, 0.0f);                          \
    colour.alpha = base.alpha;

// `base` of vertex colours and texture.
#define SHADE_BASE(p, triangle)      \
    SHADE_VERTEX_COLOUR(p, triangle) \
    if (p.texture_levels != 0u) {    \
        SHADE_TEXTURE(p)             \
    }

// For materials that may be dropped or blended: what becomes of the alpha of `base`, and wires over a colour that is
// then multiplied by its alpha.
#define SHADE_ALPHA(dropped, p)      \
    dropped = base.alpha < p.cutoff; \
    base.alpha = choose(p.keeps_alpha != 0u, base.alpha, 1.0f);
#define SHADE_OVER(colour, p)                                             \
    if (p.wires != 0u) {                                                  \
        colour = wires_over(colour, beside_edges(weights, across, down)); \
    }                                                                     \
    colour.red = colour.red * colour.alpha;                               \
    colour.green = colour.green * colour.alpha;                           \
    colour.blue = colour.blue * colour.alpha;

// All of it, for such materials.
#define SHADE(colour, dropped, p, triangle, back, px, py)            \
    {                                                                \
        SHADE_CORNERS(p, triangle, px, py)                           \
        SHADE_INSIDE                                                 \
        SHADE_BASE(p, triangle)                                      \
        SHADE_ALPHA(dropped, p)                                      \
        SHADE_NORMAL(p, back)                                        \
        if (p.shading == SHADING_WIREFRAME) {                        \
            colour = wire_colour(weights, across, down, base.alpha); \
        } else if (p.shading == SHADING_NORMALS) {                   \
            SHADE_NORMAL_AS_COLOUR(colour)                           \
        } else if (p.shading == SHADING_REFLECTION) {                \
            SHADE_REFLECTION(colour, p)                              \
        } else if (p.shading == SHADING_DEPTH) {                     \
            SHADE_DEPTH_AS_COLOUR(colour)                            \
        } else if (p.shading == SHADING_UV) {                        \
            SHADE_UV_AS_COLOUR(colour)                               \
        } else {                                                     \
            SHADE_PHONG(colour, p)                                   \
        }                                                            \
        SHADE_OVER(colour, p)                                        \
    }

#endif
