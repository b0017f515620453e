#include "raster/look.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tessera::raster {
namespace {

/// Numbers that products in a kernel bear: others become 0.
float sound(float value) {
    return std::isfinite(value) && std::abs(value) >= 0x1p-40f ? std::clamp(value, -0x1p40f, 0x1p40f) : 0.0f;
}

void put(Look& look, std::uint32_t at, float value) {
    look[at - LOOK_AT] = std::bit_cast<std::uint32_t>(sound(value));
}

void put(Look& look, std::uint32_t at, const glm::vec3& value) {
    for (int i = 0; i < 3; ++i)
        put(look, at + static_cast<std::uint32_t>(i), value[i]);
}

void put_number(Look& look, std::uint32_t at, std::uint32_t value) {
    look[at - LOOK_AT] = value;
}

std::uint32_t code(scene::Wrap wrap) {
    switch (wrap) {
        case scene::Wrap::clamp:
            return WRAP_CLAMP;
        case scene::Wrap::mirror:
            return WRAP_MIRROR;
        case scene::Wrap::repeat:
            break;
    }
    return WRAP_REPEAT;
}

std::uint32_t code(scene::Light::Kind kind) {
    switch (kind) {
        case scene::Light::Kind::point:
            return LIGHT_POINT;
        case scene::Light::Kind::spot:
            return LIGHT_SPOTTED;
        case scene::Light::Kind::directional:
            break;
    }
    return LIGHT_DIRECTIONAL;
}

void set_light(Look& look, std::uint32_t number, const scene::Light& light) {
    const std::uint32_t at = LIGHTS_AT + number * LIGHT_WORDS;
    const bool directional = light.kind == scene::Light::Kind::directional;
    put_number(look, at, code(light.kind));
    put_number(look, at + 1, light.fixed_to_camera ? 1 : 0);
    put(look, at + LIGHT_PLACE, directional ? light.direction : light.place);
    put(look, at + LIGHT_COLOUR, light.intensity);
    put(look, at + LIGHT_RANGE, light.range > 0.0f ? 1.0f / light.range : 0.0f);
    put(look, at + LIGHT_SPOT, directional ? glm::vec3(0.0f) : light.direction);
    put(look, at + LIGHT_CONE, light.cone_scale);
    put(look, at + LIGHT_CONE + 1, light.cone_offset);
}

}  // namespace

Look make_look(const render::Frame& frame) {
    Look look{};
    const render::Reflection& r = frame.reflection;
    put_number(look, LOOK_HALF_VECTOR, r.half_vector ? 1 : 0);
    put(look, LOOK_REFLECTION, glm::vec3(r.ambient, r.diffuse, r.specular));
    put(look, LOOK_SHININESS, r.shininess > 0.0f ? std::min(r.shininess, 1048576.0f) : 1.0f);
    put(look, LOOK_LIGHT, r.light);
    put_number(look, LOOK_LIGHT_IS_PLACE, r.light_is_place ? 1 : 0);
    put_number(look, LOOK_HAS_COLOUR, r.colour ? 1 : 0);
    put(look, LOOK_COLOUR, r.colour.value_or(glm::vec3(0.0f)));
    const float range = frame.depth_range.y - frame.depth_range.x;
    put(look, LOOK_DEPTH, frame.depth_range.x);
    put(look, LOOK_DEPTH + 1, range > 0.0f ? 1.0f / range : 0.0f);
    put_number(look, LOOK_TONE_CURVE, frame.tone_curve == render::ToneCurve::aces ? TONE_ACES : TONE_NONE);
    put(look, LOOK_EXPOSURE, frame.exposure);
    put(look, LOOK_ZENITH, frame.sky.zenith);
    put(look, LOOK_HORIZON, frame.sky.horizon);
    put(look, LOOK_GROUND, frame.sky.ground);
    const auto lights = static_cast<std::uint32_t>(std::min<std::size_t>(frame.lights.size(), LIGHTS_MAX));
    put_number(look, LOOK_LIGHTS, lights);
    for (std::uint32_t i = 0; i < lights; ++i)
        set_light(look, i, frame.lights[i]);
    return look;
}

std::vector<MapUse> maps_of(const scene::Material& material) {
    std::vector<MapUse> maps;
    const auto add = [&](std::uint32_t kind, const std::optional<scene::Map>& map, float strength) {
        if (map) maps.push_back({kind, *map, strength});
    };
    if (material.base_color_image) {
        maps.push_back(
            {MAP_BASE_COLOUR, {*material.base_color_image, material.wrap_u, material.wrap_v, glm::mat3(1.0f)}, 1.0f});
    }
    add(MAP_METALLIC_ROUGHNESS, material.maps.metallic_roughness, 1.0f);
    add(MAP_NORMAL, material.maps.normal, material.maps.normal_scale);
    add(MAP_OCCLUSION, material.maps.occlusion, material.maps.occlusion_strength);
    add(MAP_EMISSIVE, material.maps.emissive, 1.0f);
    return maps;
}

void set_material(Look& look, const scene::Material& material) {
    put_number(look, LOOK_UNLIT, material.unlit ? 1 : 0);
    put(look, LOOK_EMISSIVE, material.emissive);
    put(look, LOOK_METALLIC, material.metallic);
    put(look, LOOK_ROUGHNESS, material.roughness);
    const std::vector<MapUse> maps = maps_of(material);
    put_number(look, LOOK_MAPS, static_cast<std::uint32_t>(maps.size()));
    for (std::uint32_t i = 0; i < maps.size(); ++i) {
        const std::uint32_t at = MAPS_AT + i * MAP_WORDS;
        const scene::Map& map = maps[i].map;
        put_number(look, at, maps[i].kind);
        put_number(look, at + 4, code(map.wrap_u));
        put_number(look, at + 5, code(map.wrap_v));
        for (int row = 0; row < 2; ++row) {
            put(look, at + MAP_TRANSFORM + 3 * static_cast<std::uint32_t>(row),
                glm::vec3(map.transform[0][row], map.transform[1][row], map.transform[2][row]));
        }
        put(look, at + MAP_STRENGTH, maps[i].strength);
    }
}

void set_map_levels(Look& look, std::size_t number, std::uint32_t width, std::uint32_t height,
                    std::span<const std::uint32_t> levels) {
    const auto at = static_cast<std::uint32_t>(MAPS_AT + number * MAP_WORDS);
    put_number(look, at + 1, width);
    put_number(look, at + 2, height);
    put_number(look, at + 3, static_cast<std::uint32_t>(levels.size()));
    for (std::uint32_t i = 0; i < levels.size(); ++i)
        put_number(look, at + MAP_LEVELS + i, levels[i]);
}

}  // namespace tessera::raster
