#include "scene/load_obj.hpp"

#include "scene/file_bytes.hpp"
#include "scene/limits.hpp"
#include "scene/obj_materials.hpp"
#include "scene/obj_meshes.hpp"
#include "scene/obj_read.hpp"
#include "scene/obj_text.hpp"
#include "scene/topology.hpp"

#include <fmt/format.h>
#include <algorithm>

namespace tessera::scene {
namespace {

void split_or_fan(Polygons& polygons, NgonMode mode, Diagnostics& diagnostics) {
    const auto is_ngon = [](const Polygon& face) { return face.count > 4; };
    const auto ngons = std::count_if(polygons.faces.begin(), polygons.faces.end(), is_ngon);
    if (ngons == 0) return;
    if (mode == NgonMode::fan) {
        diagnostics.note(fmt::format("{} faces have more than four corners and are cut into triangles.", ngons));
        return fan_polygons(polygons);
    }
    if (2 * polygons.corners.size() > max_triangles) {
        diagnostics.refuse("the file", fmt::format("has {} corners, too many to split its faces into quads; choose to "
                                                   "triangulate them",
                                                   polygons.corners.size()));
    }
    diagnostics.note(
        fmt::format("{} faces have more than four corners: all faces of the file are split into quads.", ngons));
    fan_polygons(polygons, true);
    const auto star_shaped = std::count_if(polygons.faces.begin(), polygons.faces.end(), is_ngon);
    if (star_shaped < ngons) {
        diagnostics.note(
            fmt::format("{} of these faces are too concave to be split about their middle and are cut into "
                        "triangles before.",
                        ngons - star_shaped));
    }
    split_polygons(polygons);
}

}  // namespace

Scene load_obj(const std::filesystem::path& path, const LoadOptions& options) {
    Diagnostics diagnostics(path.string());
    const FileBytes file = read_file(path, max_obj_bytes);
    if (file.problem) diagnostics.refuse("the file", *file.problem);
    const ObjText text = check_obj_text(file.bytes, diagnostics);
    Polygons polygons = read_obj(text, diagnostics);
    clean_polygons(polygons, text, diagnostics);
    note_topology(polygons, diagnostics);
    flatten_normals(polygons);
    split_or_fan(polygons, options.ngons, diagnostics);
    complete_polygon_normals(polygons);

    Scene scene;
    scene.source = path.string();
    const auto materials = load_obj_materials(text.libraries, polygons.parts, path.parent_path(), scene, diagnostics);
    scene.meshes = make_meshes(polygons, materials, diagnostics);
    note_flat_faces(count_flat_faces(scene.meshes), diagnostics);
    if (scene.meshes.empty()) diagnostics.note("The file holds no faces to draw.");
    scene.messages = diagnostics.take_messages();
    return scene;
}

}  // namespace tessera::scene
