// The node hierarchy, flattened.
#pragma once

#include "scene/gltf_document.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace tessera::scene {

struct NodeGraph {
    std::vector<glm::dmat4> world;  ///< of every node, its ancestors included
    std::vector<int> drawn;         ///< nodes with a mesh in the scene shown, depth first, each once
    std::vector<int> cameras;       ///< likewise, nodes with a camera
    std::vector<bool> shown;        ///< of every node, whether it is in the scene shown
};

/// Takes the default scene, else the first one, else all nodes without a parent. Refuses cycles and nodes with two
/// parents; a node that a scene lists although it is another node's child, or lists twice, is drawn once and noted.
NodeGraph flatten_nodes(const Document& document);

}  // namespace tessera::scene
