#include "models.hpp"

#include "scene/scene.hpp"

namespace tessera::findings {

std::vector<Model> load_models(const std::filesystem::path& assets, const std::filesystem::path& shared) {
    std::vector<Model> models;
    for (const char* shape : {"shape:cube", "shape:icosahedron", "shape:torus"})
        models.push_back({shape, patches::make_patches(scene::load_scene(shape))});
    const auto load = [&models](const std::filesystem::path& file) {
        models.push_back({file.filename().string(), patches::make_patches(scene::load_scene(file.string()))});
    };
    for (const char* file : {"ball.glb", "pawn.glb", "figure.glb", "rabbit.glb"})
        load(assets / file);
    for (const char* file :
         {"RiggedFigure/RiggedFigure.glb", "Fox/Fox.glb", "Avocado/Avocado.gltf", "SuzanneBlender/02_suzanne.gltf",
          "obj/max6_teapot.obj", "spot/spot_control_mesh.obj", "spot/spot_quadrangulated.obj"})
        load(shared / "models" / file);
    return models;
}

std::vector<const Model*> small_triangle_models(const std::vector<Model>& models) {
    std::vector<const Model*> small;
    for (const Model& model : models) {
        if (!model.patches.has_quads && model.patches.patch_count() <= 1000) small.push_back(&model);
    }
    return small;
}

}  // namespace tessera::findings
