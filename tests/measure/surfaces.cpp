#include "surfaces.hpp"

#include "backends/registry.hpp"
#include "scene/scene.hpp"

#include <cmath>

namespace tessera::test {

patches::PatchSet load_patches(const std::string& name) {
    return patches::make_patches(scene::load_scene(name));
}

patches::PatchSet folded_sheet(double turn, bool split) {
    const auto x = static_cast<float>(std::cos(turn));
    const auto z = static_cast<float>(std::sin(turn));
    scene::Scene scene;
    scene.materials.emplace_back();
    scene::Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = {{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {x, 0, z}, {x, 1, z}, {0, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(8, {0, 0, 1});
    if (split) mesh.normals[6] = mesh.normals[7] = {-z, 0, x};
    mesh.uvs.assign(8, {0, 0});
    mesh.triangles = {0, 1, 2, 0, 2, 3, 6, 4, 5, 6, 5, 7};
    return patches::make_patches(scene);
}

measure::PatchSurface make_surface(const patches::PatchSet& patches, TessellationOptions options, float factor) {
    options.factors = PatchFactors{factor, factor, factor, factor, factor, factor};
    return measure::make_patch_surface(backends::open_device("reference"), patches, options);
}

}  // namespace tessera::test
