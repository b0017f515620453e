// glTF 2.0 files.
#pragma once

#include "scene/scene.hpp"

#include <filesystem>

namespace tessera::scene {

/// See load_scene. GLB and text are told apart by content.
Scene load_gltf(const std::filesystem::path& path, bool all_maps = false);

}  // namespace tessera::scene
