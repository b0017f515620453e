// Skins in their rest pose (glTF 2.0, section 3.7.3).
#pragma once

#include "scene/gltf_nodes.hpp"
#include "scene/gltf_primitive.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace tessera::scene {

/// For each joint: from the mesh's space in the bind pose to world space in the rest pose.
std::vector<glm::dmat4> joint_matrices(const Document& document, const NodeGraph& graph, std::size_t skin);

/// Throws Error(usage) for a joint that the skin does not have; notes vertices without any weight.
void check_influences(const Document& document, const SourcePrimitive& source, std::size_t joint_count);

/// The joints' matrices blended for one vertex by its weights, which need not sum to 1; without any usable weight the
/// matrix of its first joint.
glm::dmat4 blended_matrix(const SourcePrimitive& source, const std::vector<glm::dmat4>& joints, std::size_t vertex);

}  // namespace tessera::scene
