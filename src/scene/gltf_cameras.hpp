// The cameras of a glTF file.
#pragma once

#include "scene/gltf_nodes.hpp"
#include "scene/scene.hpp"

namespace tessera::scene {

/// Adds the cameras of the scene shown, one for each node that carries one, in node order. A camera with values that
/// glTF rules out (3.10.3: angles, planes, magnitudes), or a node whose transform leaves no direction, is left out with
/// a message.
void load_cameras(const Document& document, const NodeGraph& graph, Scene& scene);

}  // namespace tessera::scene
