#include "scene/load_gltf.hpp"

#include "scene/file_bytes.hpp"
#include "scene/gltf_bake.hpp"
#include "scene/gltf_cameras.hpp"
#include "scene/gltf_container.hpp"
#include "scene/gltf_document.hpp"
#include "scene/gltf_guides.hpp"
#include "scene/gltf_lights.hpp"
#include "scene/gltf_materials.hpp"
#include "scene/gltf_ngons.hpp"
#include "scene/gltf_skin.hpp"
#include "scene/json_object.hpp"
#include "scene/limits.hpp"
#include "scene/normals.hpp"
#include "scene/topology.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <map>

namespace tessera::scene {
namespace {

/// Adds up and refuses before the memory for `what` is allocated.
class Budget {
public:
    Budget(const char* what, std::uint64_t limit) : what_(what), limit_(limit) {}
    void spend(std::uint64_t amount, const std::string& element, const Diagnostics& diagnostics) {
        spent_ += amount;
        if (spent_ > limit_) {
            diagnostics.refuse(
                element, fmt::format("brings the model to {} {}, more than the {} supported", spent_, what_, limit_));
        }
    }

private:
    const char* what_;
    std::uint64_t limit_;
    std::uint64_t spent_ = 0;
};

using SourceMesh = std::vector<SourcePrimitive>;

/// Refuses a file whose primitives together, read one by one, would take too much memory.
void check_sizes(const Document& document) {
    Budget vertices("vertices", max_vertices);
    Budget indices("indices", 3 * max_triangles);
    const auto& model = document.model;
    const auto count = [&](int accessor) { return model.accessors[static_cast<std::size_t>(accessor)].count; };
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
        for (std::size_t p = 0; p < model.meshes[m].primitives.size(); ++p) {
            const auto& primitive = model.meshes[m].primitives[p];
            const std::string element = fmt::format("meshes[{}].primitives[{}]", m, p);
            const auto position = primitive.attributes.find("POSITION");
            if (position != primitive.attributes.end()) {
                vertices.spend(count(position->second), element, document.diagnostics);
            }
            if (primitive.indices >= 0) indices.spend(count(primitive.indices), element, document.diagnostics);
        }
    }
}

/// Reads every mesh, used or not: a file is sound as a whole or it is refused.
std::vector<SourceMesh> read_meshes(const Document& document) {
    check_sizes(document);
    std::vector<SourceMesh> meshes(document.model.meshes.size());
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        for (std::size_t p = 0; p < document.model.meshes[m].primitives.size(); ++p) {
            meshes[m].push_back(read_primitive(document, m, p));
        }
    }
    return meshes;
}

std::vector<double> morph_weights(const tinygltf::Node& node, const tinygltf::Mesh& mesh) {
    std::vector<double> weights = node.weights.empty() ? mesh.weights : node.weights;
    const bool none = std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0.0; });
    return none ? std::vector<double>{} : weights;
}

class Assembly {
public:
    Assembly(const Document& document, const NodeGraph& graph, Scene& scene)
        : document_(document), graph_(graph), scene_(scene), sources_(read_meshes(document)) {}

    /// Adds what the scene shows, after a look at how much that is.
    void add_nodes() {
        for (const int node : graph_.drawn)
            spend(node);
        for (const int node : graph_.drawn)
            add_node(node);
    }

    /// What was found about all meshes together.
    void note_topology() const {
        note_unused_vertices(unused_, document_.diagnostics);
        note_crowded_edges(crowded_, document_.diagnostics);
        note_flat_faces(flat_, document_.diagnostics);
    }

    /// True if a primitive had triangles, but none whose positions are finite.
    bool lost_a_primitive() const { return unsound_; }

private:
    static bool is_skinned(const tinygltf::Node& node, const SourcePrimitive& source) {
        return node.skin >= 0 && source.influences > 0;
    }

    /// Whether a node leaves anything of a primitive to draw.
    bool is_shown(int index, const SourcePrimitive& source) const {
        const auto i = static_cast<std::size_t>(index);
        return is_skinned(document_.model.nodes[i], source) || keeps_surfaces(graph_.world[i]);
    }

    const SourceMesh& source_mesh(int node) const {
        return sources_[static_cast<std::size_t>(document_.model.nodes[static_cast<std::size_t>(node)].mesh)];
    }

    void spend(int index) {
        for (const SourcePrimitive& source : source_mesh(index)) {
            if ((source.triangles.empty() && source.guide_ends.empty()) || !is_shown(index, source)) continue;
            const std::string element = fmt::format("nodes[{}]", index);
            vertices_.spend(source.positions.size() + source.guide_points.size(), element, document_.diagnostics);
            triangles_.spend(source.triangles.size() / 3, element, document_.diagnostics);
        }
    }

    void add_node(int index) {
        const auto& node = document_.model.nodes[static_cast<std::size_t>(index)];
        const auto mesh = static_cast<std::size_t>(node.mesh);
        const std::string element = fmt::format("nodes[{}]", index);
        Pose pose;
        pose.world = graph_.world[static_cast<std::size_t>(index)];
        if (node.skin >= 0) pose.joints = joint_matrices(document_, graph_, static_cast<std::size_t>(node.skin));
        pose.morph_weights = morph_weights(node, document_.model.meshes[mesh]);

        const std::size_t first = scene_.meshes.size();
        const std::size_t first_guides = scene_.guides.size();
        for (const SourcePrimitive& source : source_mesh(index)) {
            if (source.triangles.empty() && source.guide_ends.empty()) continue;
            if (!is_shown(index, source)) {
                document_.diagnostics.note(element + ": its transform leaves no surface; its mesh is left out.");
                continue;
            }
            if (node.skin >= 0 && !is_skinned(node, source)) {
                document_.diagnostics.note(fmt::format("{} has a skin, but {} has no JOINTS_0: it moves with its node.",
                                                       element, source.element));
            }
            if (!source.guide_ends.empty()) {
                Guides& guides = guides_of(first_guides, name_of(node, mesh), material_of(source));
                bake_guides(document_, source, pose, guides);
                continue;
            }
            Mesh baked = bake(document_, source, pose);
            if (baked.triangles.empty()) {
                unsound_ = true;
                continue;
            }
            unused_ += count_unused_vertices(baked);
            baked.name = name_of(node, mesh, source);
            if (has_ngon_encoding(*source.primitive)) restore_quads(baked);
            baked.material = material_of(source);
            scene_.meshes.push_back(std::move(baked));
        }
        const std::span own = std::span(scene_.meshes).subspan(first);
        complete_normals(own);
        crowded_ += count_crowded_edges(own);
        flat_ += count_flat_faces(own);
        std::erase_if(scene_.guides, [](const Guides& guides) { return guides.ends.empty(); });
    }

    /// The guides with this material among those of a node, which begin at `first`.
    Guides& guides_of(std::size_t first, const std::string& name, std::uint32_t material) {
        material = double_sided(material);
        for (std::size_t i = first; i < scene_.guides.size(); ++i) {
            if (scene_.guides[i].material == material) return scene_.guides[i];
        }
        scene_.guides.push_back({name + "/hair", {}, {}, {}, {}, material});
        return scene_.guides.back();
    }

    /// Ribbons are seen from both sides: the material itself, or a copy of it that is.
    std::uint32_t double_sided(std::uint32_t material) {
        if (scene_.materials[material].double_sided) return material;
        const auto [copy, added] = double_sided_.emplace(material, static_cast<std::uint32_t>(scene_.materials.size()));
        if (added) {
            scene_.materials.push_back(scene_.materials[material]);
            scene_.materials.back().double_sided = true;
        }
        return copy->second;
    }

    /// A primitive without a material takes the default one, which load_materials puts last.
    std::uint32_t material_of(const SourcePrimitive& source) const {
        const int material = source.primitive->material;
        return material >= 0 ? static_cast<std::uint32_t>(material) : default_material_;
    }

    std::string name_of(const tinygltf::Node& node, std::size_t mesh) const {
        const std::string& mesh_name = document_.model.meshes[mesh].name;
        const std::string& name = !node.name.empty() ? node.name : mesh_name;
        return name.empty() ? fmt::format("meshes[{}]", mesh) : name;
    }

    std::string name_of(const tinygltf::Node& node, std::size_t mesh, const SourcePrimitive& source) const {
        std::string name = name_of(node, mesh);
        if (sources_[mesh].size() > 1) name += fmt::format("/{}", &source - sources_[mesh].data());
        return name;
    }

    const Document& document_;
    const NodeGraph& graph_;
    Scene& scene_;
    std::vector<SourceMesh> sources_;
    const std::uint32_t default_material_ = static_cast<std::uint32_t>(scene_.materials.size() - 1);
    std::map<std::uint32_t, std::uint32_t> double_sided_;  // copies made
    Budget vertices_{"vertices", max_vertices};
    Budget triangles_{"triangles", max_triangles};
    std::size_t unused_ = 0, crowded_ = 0, flat_ = 0;
    bool unsound_ = false;
};

}  // namespace

Scene load_gltf(const std::filesystem::path& path, bool all_maps) {
    Diagnostics diagnostics(path.string());
    const FileBytes file = read_file(path, max_file_bytes);
    if (file.problem) diagnostics.refuse("the file", *file.problem);
    const Container container = open_container(file.bytes, diagnostics);
    const nlohmann::json json = parse_json(container.json, diagnostics);
    const CheckedJson checked = check_json(json, diagnostics, all_maps);

    std::vector<std::vector<std::byte>> storage;
    auto buffers = load_buffers(checked.buffers, container.binary, path.parent_path(), storage, diagnostics);
    const Document document{parse_model(checked.json, diagnostics),
                            std::move(buffers),
                            checked.images,
                            checked.cameras,
                            path.parent_path(),
                            diagnostics,
                            all_maps};
    check_model(document);
    const NodeGraph graph = flatten_nodes(document);

    Scene scene;
    scene.source = path.string();
    load_materials(document, scene);
    load_cameras(document, graph, scene);
    if (all_maps) load_lights(json, document, graph, scene);
    Assembly assembly(document, graph, scene);
    assembly.add_nodes();
    assembly.note_topology();
    if (scene.meshes.empty() && scene.guides.empty() && assembly.lost_a_primitive()) {
        diagnostics.refuse("the file", "has no triangle whose positions are all finite");
    }
    if (scene.meshes.empty() && scene.guides.empty()) diagnostics.note("The file holds no triangles to draw.");
    scene.messages = diagnostics.take_messages();
    return scene;
}

}  // namespace tessera::scene
