// From a primitive in its own space to a mesh in world space.
#pragma once

#include "scene/gltf_nodes.hpp"
#include "scene/gltf_primitive.hpp"
#include "scene/scene.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace tessera::scene {

/// How a node shows its mesh.
struct Pose {
    glm::dmat4 world{1.0};           ///< used where there are no joints
    std::vector<glm::dmat4> joints;  ///< joint matrices of the node's skin, if it has one
    std::vector<double> morph_weights;
};

/// Applies morph targets, then skin or node transform, in double precision. Normals go by the inverse transpose and
/// are made unit; one that the file does not have, or that is of no use, comes out as zero for complete_normals.
/// Tangents go with the surface; their handedness changes where the transform mirrors.
/// Winding is turned where the transform mirrors. Triangles with positions that are not finite are dropped together
/// with those vertices, and a message counts them. Name and material are left to the caller.
Mesh bake(const Document& document, const SourcePrimitive& source, const Pose& pose);

/// True if the transform leaves a surface: false where it flattens everything to a line or a point.
bool keeps_surfaces(const glm::dmat4& transform);

}  // namespace tessera::scene
