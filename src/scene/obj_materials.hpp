// Material libraries of OBJ files.
#pragma once

#include "scene/diagnostics.hpp"
#include "scene/polygons.hpp"
#include "scene/scene.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tessera::scene {

/// Fills the materials and images of `scene` with what the parts use, in that order, and returns each part's material.
/// Kd, d and map_Kd are read; a library, material or texture that is missing or unsound is noted and does without.
/// Textures are found from the library's folder; neither may lie outside `folder`. Materials are double-sided: the
/// format has no word about it, and surfaces with a boundary are common.
std::vector<std::uint32_t> load_obj_materials(const std::vector<std::string>& libraries,
                                              const std::vector<PolygonPart>& parts,
                                              const std::filesystem::path& folder, Scene& scene,
                                              Diagnostics& diagnostics);

}  // namespace tessera::scene
