// Vertex normals where a file has none.
#pragma once

#include "scene/scene.hpp"

#include <span>

namespace tessera::scene {

/// Replaces every zero normal of `meshes` by the angle-weighted mean of the face normals around its position
/// (Thuermer and Wuethrich, 1998). Vertices at bitwise equal positions count as one, in all of `meshes` together, and
/// get equal bits. Faces without area do not count; a vertex that has no others gets (0, 0, 1).
void complete_normals(std::span<Mesh> meshes);

}  // namespace tessera::scene
