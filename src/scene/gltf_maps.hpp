// The maps of metallic-roughness materials, and how texture coordinates reach them.
#pragma once

#include "scene/gltf_document.hpp"
#include "scene/scene.hpp"

#include <functional>
#include <glm/glm.hpp>
#include <optional>

namespace tessera::scene {

/// Where a material's texture coordinates come from: a set of the file, transformed by KHR_texture_transform.
struct UvSource {
    int set = 0;
    glm::dmat3 transform{1.0};
    bool textured = false;
    bool repeats = true;  ///< false where the sampler clamps or mirrors
};

/// The coordinates of the base colour; with all maps and without a base colour, those of the first other map.
UvSource uv_source(const Document& document, int material);

/// The scene's image of a texture of the file, if there is one.
using ImageOfTexture = std::function<std::optional<std::uint32_t>(int texture)>;

/// Sets what LoadOptions::all_maps asks for. Maps that use another set of coordinates than uv_source are left out with
/// a message.
void load_maps(const Document& document, int material, const ImageOfTexture& load, Material& to);

}  // namespace tessera::scene
