// Lights of KHR_lights_punctual.
#pragma once

#include "scene/gltf_nodes.hpp"
#include "scene/scene.hpp"

namespace tessera::scene {

/// Adds the lights of the scene shown, one for each node that carries one, in node order; `json` is the file's text. A
/// light with values that the extension rules out is left out with a message. Throws Error(usage) for wrong types and
/// references.
void load_lights(const nlohmann::json& json, const Document& document, const NodeGraph& graph, Scene& scene);

}  // namespace tessera::scene
