// Base colours: factors, textures, and how texture coordinates reach them.
#pragma once

#include "scene/gltf_document.hpp"
#include "scene/scene.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace tessera::scene {

/// Where a material's texture coordinates come from: a set of the file, transformed by KHR_texture_transform.
struct UvSource {
    int set = 0;
    glm::dmat3 transform{1.0};
    bool textured = false;
    bool repeats = true;  ///< false where the sampler clamps or mirrors
};

/// Fills the materials and images of `scene`, materials in the file's order with a default one
/// behind them where a primitive has none. Images
/// that no base colour uses are left out; one that cannot be read is dropped with a message.
void load_materials(const Document& document, Scene& scene);

UvSource uv_source(const Document& document, int material);

}  // namespace tessera::scene
