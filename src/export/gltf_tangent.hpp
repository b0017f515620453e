// Tangents as glTF wants them.
#pragma once

#include "base/tangent.hpp"
#include "base/vertex.hpp"

namespace tessera::exporting {

/// TANGENT of glTF 2.0, section 3.7.2.1: a unit vector, and the sign with which readers make the bitangent,
/// cross(normal, tangent) * w.
struct GltfTangent {
    float x, y, z, w;
};
static_assert(sizeof(GltfTangent) == 16);

/// The tangent turned to a right angle with the vertex normal, as MikkTSpace has it, on which normal maps for glTF are
/// baked. Where it is parallel to the normal, the direction whose bitangent is nearest to the given one, or any at a
/// right angle. Normal, tangent and bitangent are unit.
GltfTangent gltf_tangent(const Vertex& vertex, const Tangent& frame);

}  // namespace tessera::exporting
