#include "scene/gltf_maps.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

namespace tessera::scene {
namespace {

/// A reference to a texture: the types of tinygltf have these in common.
struct TextureUse {
    int texture = -1;
    int set = 0;
    const tinygltf::ExtensionMap* extensions = nullptr;
};

template <typename Info>
TextureUse use_of(const Info& info) {
    return {info.index, info.texCoord, &info.extensions};
}

struct Placement {
    int set = 0;
    glm::dmat3 transform{1.0};
};

/// Coordinates of a texture: KHR_texture_transform, where there is one.
Placement placement_of(const TextureUse& use) {
    Placement placement{use.set, glm::dmat3(1.0)};
    const auto extension = use.extensions->find("KHR_texture_transform");
    if (extension == use.extensions->end()) return placement;
    const tinygltf::Value& value = extension->second;
    const auto pair = [&](const char* key, double otherwise) {
        if (!value.Has(key)) return glm::dvec2(otherwise);
        const auto& array = value.Get(key);
        return glm::dvec2(array.Get(0).GetNumberAsDouble(), array.Get(1).GetNumberAsDouble());
    };
    if (value.Has("texCoord")) placement.set = value.Get("texCoord").GetNumberAsInt();
    const glm::dvec2 offset = pair("offset", 0.0);
    const glm::dvec2 scale = pair("scale", 1.0);
    const double angle = value.Has("rotation") ? value.Get("rotation").GetNumberAsDouble() : 0.0;
    // Translation * rotation * scale. The angle turns counter-clockwise as seen, and v points down.
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    placement.transform =
        glm::dmat3(c * scale.x, -s * scale.x, 0.0, s * scale.y, c * scale.y, 0.0, offset.x, offset.y, 1.0);
    return placement;
}

Wrap wrap_of(int code) {
    if (code == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp;
    if (code == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::mirror;
    return Wrap::repeat;
}

std::array<Wrap, 2> wraps_of(const Document& document, int texture) {
    const int sampler = document.model.textures[static_cast<std::size_t>(texture)].sampler;
    if (sampler < 0) return {Wrap::repeat, Wrap::repeat};
    const auto& s = document.model.samplers[static_cast<std::size_t>(sampler)];
    return {wrap_of(s.wrapS), wrap_of(s.wrapT)};
}

/// The texture whose coordinates the vertices carry.
TextureUse leading_use(const Document& document, int material) {
    if (material < 0) return {};
    const auto& m = document.model.materials[static_cast<std::size_t>(material)];
    const auto& pbr = m.pbrMetallicRoughness;
    if (pbr.baseColorTexture.index >= 0 || !document.all_maps) return use_of(pbr.baseColorTexture);
    for (const TextureUse& use : {use_of(pbr.metallicRoughnessTexture), use_of(m.normalTexture),
                                  use_of(m.occlusionTexture), use_of(m.emissiveTexture)}) {
        if (use.texture >= 0) return use;
    }
    return {};
}

float unit(double value) {
    return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

}  // namespace

UvSource uv_source(const Document& document, int material) {
    UvSource source;
    const TextureUse use = leading_use(document, material);
    if (use.texture < 0) return source;
    source.textured = true;
    const auto wraps = wraps_of(document, use.texture);
    // With all maps, wrap modes are obeyed.
    source.repeats = document.all_maps || (wraps[0] == Wrap::repeat && wraps[1] == Wrap::repeat);
    const Placement placement = placement_of(use);
    source.set = placement.set;
    source.transform = placement.transform;
    return source;
}

void load_maps(const Document& document, int material, const ImageOfTexture& load, Material& to) {
    const auto& from = document.model.materials[static_cast<std::size_t>(material)];
    const auto& pbr = from.pbrMetallicRoughness;
    to.metallic = unit(pbr.metallicFactor);
    to.roughness = unit(pbr.roughnessFactor);
    double strength = 1.0;
    if (const auto found = from.extensions.find("KHR_materials_emissive_strength"); found != from.extensions.end()) {
        if (found->second.Has("emissiveStrength")) strength = found->second.Get("emissiveStrength").GetNumberAsDouble();
    }
    for (int i = 0; i < 3; ++i) {
        to.emissive[i] = static_cast<float>(std::clamp(from.emissiveFactor[static_cast<std::size_t>(i)], 0.0, 1.0) *
                                            std::clamp(strength, 0.0, 1e9));
    }
    to.unlit = from.extensions.contains("KHR_materials_unlit");

    const UvSource carried = uv_source(document, material);
    const double determinant = glm::determinant(carried.transform);
    const bool invertible = std::isfinite(1.0 / determinant);
    if (pbr.baseColorTexture.index >= 0) {
        const auto wraps = wraps_of(document, pbr.baseColorTexture.index);
        to.wrap_u = wraps[0];
        to.wrap_v = wraps[1];
    }
    const auto map_of = [&](const TextureUse& use, const char* name) -> std::optional<Map> {
        if (use.texture < 0) return std::nullopt;
        const Placement placement = placement_of(use);
        if (placement.set != carried.set) {
            document.diagnostics.note(
                fmt::format("materials[{}].{} uses TEXCOORD_{}, but vertices carry TEXCOORD_{} alone: it is left out.",
                            material, name, placement.set, carried.set));
            return std::nullopt;
        }
        const auto image = load(use.texture);
        if (!image) return std::nullopt;
        const auto wraps = wraps_of(document, use.texture);
        Map map{*image, wraps[0], wraps[1], glm::mat3(1.0f)};
        if (placement.transform != carried.transform && invertible) {
            map.transform = glm::mat3(placement.transform * glm::inverse(carried.transform));
        }
        return map;
    };
    to.maps.metallic_roughness = map_of(use_of(pbr.metallicRoughnessTexture), "metallicRoughnessTexture");
    to.maps.normal = map_of(use_of(from.normalTexture), "normalTexture");
    to.maps.occlusion = map_of(use_of(from.occlusionTexture), "occlusionTexture");
    to.maps.emissive = map_of(use_of(from.emissiveTexture), "emissiveTexture");
    to.maps.normal_scale = static_cast<float>(std::clamp(from.normalTexture.scale, -1e3, 1e3));
    to.maps.occlusion_strength = unit(from.occlusionTexture.strength);
}

}  // namespace tessera::scene
