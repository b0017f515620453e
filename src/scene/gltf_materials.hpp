// Materials: factors, base colours, and with all maps the rest.
#pragma once

#include "scene/gltf_document.hpp"
#include "scene/scene.hpp"

namespace tessera::scene {

/// Fills the materials and images of `scene`, materials in the file's order with a default one
/// behind them where a primitive has none. Images
/// that no base colour uses are left out; one that cannot be read is dropped with a message.
void load_materials(const Document& document, Scene& scene);

}  // namespace tessera::scene
