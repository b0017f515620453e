// Polygons of three and four corners as meshes.
#pragma once

#include "scene/diagnostics.hpp"
#include "scene/polygons.hpp"
#include "scene/scene.hpp"

#include <vector>

namespace tessera::scene {

/// One mesh for each part that has faces, its vertices in the order in which faces use them. Every corner must have a
/// normal. Tags that belong to no face are noted and left out. `materials` has one entry per part.
std::vector<Mesh> make_meshes(const Polygons& polygons, const std::vector<std::uint32_t>& materials,
                              Diagnostics& diagnostics);

}  // namespace tessera::scene
