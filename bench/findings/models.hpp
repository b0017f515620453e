// The models that are measured.
#pragma once

#include "patches/patches.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tessera::findings {

struct Model {
    std::string name;  ///< the file's name without its folder, or the shape's
    patches::PatchSet patches;
};

/// Shapes, the project's own models in `assets`, and models of the shared test data. Throws Error(usage) for one that
/// is not there.
std::vector<Model> load_models(const std::filesystem::path& assets, const std::filesystem::path& shared);

/// Those of up to a thousand triangles and no quads.
std::vector<const Model*> small_triangle_models(const std::vector<Model>& models);

}  // namespace tessera::findings
