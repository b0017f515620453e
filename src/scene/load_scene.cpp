#include "base/error.hpp"
#include "scene/diagnostics.hpp"
#include "scene/load_gltf.hpp"
#include "scene/load_obj.hpp"
#include "scene/normals.hpp"
#include "scene/scene.hpp"
#include "scene/shapes.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>

namespace tessera::scene {
namespace {

std::string lower_case_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return extension;
}

Scene load_as_given(const std::string& name, const LoadOptions& options) {
    if (is_shape(name)) return make_shape(name);
    const std::filesystem::path path(name);
    const std::string extension = lower_case_extension(path);
    if (extension == ".gltf" || extension == ".glb") return load_gltf(path, options.all_maps);
    if (extension == ".obj") return load_obj(path, options);
    throw Error(ErrorKind::usage, fmt::format("{}: the extension {} is not known; .gltf, .glb and .obj files and "
                                              "shape:NAME can be read.",
                                              name, in_quotes(extension)));
}

}  // namespace

Scene load_scene(const std::string& name, const LoadOptions& options) {
    Scene scene = load_as_given(name, options);
    if (options.smooth_normals) {
        for (Mesh& mesh : scene.meshes) {
            mesh.normals.assign(mesh.positions.size(), glm::vec3(0.0f));
        }
        complete_normals(scene.meshes);
    }
    return scene;
}

}  // namespace tessera::scene
