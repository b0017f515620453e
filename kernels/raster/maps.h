// The maps of metallic-roughness materials (glTF 2.0, section 3.9): any number of kinds, sizes, wrap modes and
// transforms, sampled one after the other by the same code.
#ifndef TESSERA_RASTER_MAPS_H
#define TESSERA_RASTER_MAPS_H

#include "raster/shading.h"

KERNELS_BEGIN

/// What a material is in a point.
STRUCT(Surface) {
    Colour base;
    float metallic;
    float roughness;
    float occlusion;
    Vector emissive;
    Vector bump;  // normal in the tangent frame
};

/// A coordinate of a map brought into [0, 1].
FUNCTION float wrapped(float x, uint wrap) {
    const float repeated = x - to_float(floor_to_int(x));
    const float pair = x - 2.0f * to_float(floor_to_int(0.5f * x));
    const float mirrored = choose(pair > 1.0f, 2.0f - pair, pair);
    const float clamped = at_most(at_least(x, 0.0f), 1.0f);
    return choose(wrap == WRAP_REPEAT, repeated, choose(wrap == WRAP_CLAMP, clamped, mirrored));
}

/// The texel beside the last or before the first: at the other side where coordinates repeat, else the same.
FUNCTION uint wrapped_texel(int place, uint size, uint wrap) {
    const uint before = choose_bits(wrap == WRAP_REPEAT, size - 1u, 0u);
    const uint behind = choose_bits(wrap == WRAP_REPEAT, 0u, size - 1u);
    return choose_bits(place < 0, before, choose_bits(place < to_int(size), to_uint(place), behind));
}

FUNCTION Taps make_map_taps(uint width, uint height, uint wrap_u, uint wrap_v, uint level, float u, float v) {
    const uint w = level_extent(width, level);
    const uint h = level_extent(height, level);
    const float x = wrapped(u, wrap_u) * to_float(w) - 0.5f;
    const float y = wrapped(v, wrap_v) * to_float(h) - 0.5f;
    const int left = floor_to_int(x);
    const int top = floor_to_int(y);
    const float fx = x - to_float(left);
    const float fy = y - to_float(top);
    const uint x0 = wrapped_texel(left, w, wrap_u);
    const uint y0 = wrapped_texel(top, h, wrap_v);
    const uint x1 = wrapped_texel(left + 1, w, wrap_u);
    const uint y1 = wrapped_texel(top + 1, h, wrap_v);
    return bilinear_taps(w, x0, y0, x1, y1, fx, fy);
}

/// As texture_level, for changes of a map's coordinates in texels.
FUNCTION float map_level(float ux, float vx, float uy, float vy, uint levels) {
    const float across = flushed_square(ux) + flushed_square(vx);
    const float down = flushed_square(uy) + flushed_square(vy);
    const float longest = at_most(at_least(at_least(across, down), 1.0f), 1e18f);
    return at_most(0.5f * rough_log2(longest), to_float(levels - 1u));
}

FUNCTION Surface apply_map(Surface surface, uint kind, float strength, Colour texel) {
    Surface s = surface;
    const bool base = kind == MAP_BASE_COLOUR;
    const bool metal = kind == MAP_METALLIC_ROUGHNESS;
    const bool bump = kind == MAP_NORMAL;
    const bool emissive = kind == MAP_EMISSIVE;
    s.base.red = choose(base, flush_tiny(s.base.red * texel.red), s.base.red);
    s.base.green = choose(base, flush_tiny(s.base.green * texel.green), s.base.green);
    s.base.blue = choose(base, flush_tiny(s.base.blue * texel.blue), s.base.blue);
    s.base.alpha = choose(base, flush_tiny(s.base.alpha * texel.alpha), s.base.alpha);
    s.metallic = choose(metal, flush_tiny(s.metallic * texel.blue), s.metallic);
    s.roughness = choose(metal, flush_tiny(s.roughness * texel.green), s.roughness);
    s.bump.x = choose(bump, (2.0f * texel.red - 1.0f) * strength, s.bump.x);
    s.bump.y = choose(bump, (2.0f * texel.green - 1.0f) * strength, s.bump.y);
    s.bump.z = choose(bump, 2.0f * texel.blue - 1.0f, s.bump.z);
    s.occlusion = choose(kind == MAP_OCCLUSION, 1.0f + strength * (texel.red - 1.0f), s.occlusion);
    s.emissive.x = choose(emissive, flush_tiny(s.emissive.x * texel.red), s.emissive.x);
    s.emissive.y = choose(emissive, flush_tiny(s.emissive.y * texel.green), s.emissive.y);
    s.emissive.z = choose(emissive, flush_tiny(s.emissive.z * texel.blue), s.emissive.z);
    return s;
}

KERNELS_END

// Codes are sRGB in base colours and emission, linear in the rest.
#define MAP_DECODE(texels, coded, code) \
    choose(coded, SRGB_DECODE(texels, code), to_float((code)&255u) * 0.0039215688593685627f)
#define ADD_MAP_TEXEL(colour, texels, coded, at, weight)                                            \
    {                                                                                               \
        const uint texel = texels[at];                                                              \
        colour.red = colour.red + (weight)*MAP_DECODE(texels, coded, texel);                        \
        colour.green = colour.green + (weight)*MAP_DECODE(texels, coded, texel >> 8u);              \
        colour.blue = colour.blue + (weight)*MAP_DECODE(texels, coded, texel >> 16u);               \
        colour.alpha = colour.alpha + (weight) * (to_float(texel >> 24u) * 0.0039215688593685627f); \
    }

// A step of shading (shading.h), after SHADE_INSIDE: declares `surface`.
#define SHADE_MAPS(p)                                                                                          \
    Surface surface;                                                                                           \
    surface.base = base;                                                                                       \
    surface.metallic = LOOK_FLOAT(texels, LOOK_METALLIC);                                                      \
    surface.roughness = LOOK_FLOAT(texels, LOOK_ROUGHNESS);                                                    \
    surface.occlusion = 1.0f;                                                                                  \
    surface.emissive = LOOK_VECTOR(texels, LOOK_EMISSIVE);                                                     \
    surface.bump = make_vector(0.0f, 0.0f, 1.0f);                                                              \
    {                                                                                                          \
        const float u = weigh(inside, ca.u, cb.u, cc.u);                                                       \
        const float v = weigh(inside, ca.v, cb.v, cc.v);                                                       \
        const float u_across = weigh(across, ca.u, cb.u, cc.u);                                                \
        const float v_across = weigh(across, ca.v, cb.v, cc.v);                                                \
        const float u_down = weigh(down, ca.u, cb.u, cc.u);                                                    \
        const float v_down = weigh(down, ca.v, cb.v, cc.v);                                                    \
        const uint maps = texels[LOOK_MAPS];                                                                   \
        for (uint m = 0u; m < maps; ++m) {                                                                     \
            const uint map = MAPS_AT + m * MAP_WORDS;                                                          \
            const uint kind = texels[map];                                                                     \
            const uint width = texels[map + 1u];                                                               \
            const uint height = texels[map + 2u];                                                              \
            const uint levels = texels[map + 3u];                                                              \
            const uint wrap_u = texels[map + 4u];                                                              \
            const uint wrap_v = texels[map + 5u];                                                              \
            const Vector row_u = LOOK_VECTOR(texels, map + MAP_TRANSFORM);                                     \
            const Vector row_v = LOOK_VECTOR(texels, map + MAP_TRANSFORM + 3u);                                \
            const float map_u = sane_coordinate((row_u.x * u + row_u.y * v) + row_u.z);                        \
            const float map_v = sane_coordinate((row_v.x * u + row_v.y * v) + row_v.z);                        \
            const float w = to_float(width);                                                                   \
            const float h = to_float(height);                                                                  \
            const float level = map_level(                                                                     \
                w * (row_u.x * u_across + row_u.y * v_across), h * (row_v.x * u_across + row_v.y * v_across),  \
                w * (row_u.x * u_down + row_u.y * v_down), h * (row_v.x * u_down + row_v.y * v_down), levels); \
            const uint whole = to_uint(floor_to_int(level));                                                   \
            const float part = level - to_float(whole);                                                        \
            const bool coded =                                                                                 \
                choose_bits(kind == MAP_BASE_COLOUR, 1u, choose_bits(kind == MAP_EMISSIVE, 1u, 0u)) != 0u;     \
            Colour found;                                                                                      \
            found.red = 0.0f;                                                                                  \
            found.green = 0.0f;                                                                                \
            found.blue = 0.0f;                                                                                 \
            found.alpha = 0.0f;                                                                                \
            for (uint finer = 0u; finer < 2u; ++finer) {                                                       \
                const uint wanted = whole + finer;                                                             \
                const uint chosen = choose_bits(wanted < levels, wanted, levels - 1u);                         \
                const float part_of = choose(finer == 0u, 1.0f - part, part);                                  \
                const Taps taps = make_map_taps(width, height, wrap_u, wrap_v, chosen, map_u, map_v);          \
                const uint begin = texels[map + MAP_LEVELS + chosen];                                          \
                ADD_MAP_TEXEL(found, texels, coded, begin + taps.a, part_of * taps.wa)                         \
                ADD_MAP_TEXEL(found, texels, coded, begin + taps.b, part_of * taps.wb)                         \
                ADD_MAP_TEXEL(found, texels, coded, begin + taps.c, part_of * taps.wc)                         \
                ADD_MAP_TEXEL(found, texels, coded, begin + taps.d, part_of * taps.wd)                         \
            }                                                                                                  \
            surface = apply_map(surface, kind, LOOK_FLOAT(texels, map + MAP_STRENGTH), found);                 \
        }                                                                                                      \
    }

#endif
