#include "scene/obj_meshes.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <unordered_map>

namespace tessera::scene {
namespace {

struct CornerHash {
    std::size_t operator()(const Corner& c) const {
        std::uint64_t hash = 0;
        for (const std::uint32_t i : {c.position, c.uv, c.normal})
            hash = (hash ^ i) * 0x9e3779b97f4a7c15u;
        return hash ^ (hash >> 29);
    }
};

struct CornerEqual {
    bool operator()(const Corner& a, const Corner& b) const {
        return a.position == b.position && a.uv == b.uv && a.normal == b.normal;
    }
};

/// Vertices of the mesh that is being made, found again by corner and by position.
class Vertices {
public:
    Vertices(const Polygons& polygons, Mesh& mesh) : polygons_(polygons), mesh_(mesh) {}

    std::uint32_t place(const Corner& corner) {
        const auto number = static_cast<std::uint32_t>(mesh_.positions.size());
        const auto [entry, is_new] = by_corner_.try_emplace(corner, number);
        if (is_new) {
            mesh_.positions.push_back(polygons_.positions[corner.position]);
            mesh_.normals.push_back(polygons_.normals[corner.normal]);
            mesh_.uvs.push_back(corner.uv == no_index ? glm::vec2(0.0f) : polygons_.uvs[corner.uv]);
            first_.try_emplace(corner.position, number);
        }
        return entry->second;
    }

    /// The first vertex at a position of the file, or no_index.
    std::uint32_t first_at(std::uint32_t position) const {
        const auto found = first_.find(position);
        return found == first_.end() ? no_index : found->second;
    }

private:
    const Polygons& polygons_;
    Mesh& mesh_;
    std::unordered_map<Corner, std::uint32_t, CornerHash, CornerEqual> by_corner_;
    std::unordered_map<std::uint32_t, std::uint32_t> first_;
};

/// Hands the file's tags to the meshes they concern, and keeps count of those that none has.
class TagGiver {
public:
    explicit TagGiver(const Polygons& polygons) : polygons_(polygons) {
        for (const Crease& crease : polygons.tags.creases)
            creases_[edge_key(crease.a, crease.b)].sharpness = crease.sharpness;
        corner_used_.resize(polygons.tags.corners.size());
    }

    void give(std::span<const Polygon* const> faces, std::uint32_t part, const Vertices& vertices, Mesh& mesh) {
        mesh.tags.interpolate_boundary = polygons_.tags.interpolate_boundary;
        mesh.tags.holes = polygons_.parts[part].holes;
        for (std::size_t i = 0; i < polygons_.tags.corners.size(); ++i) {
            const SharpVertex& corner = polygons_.tags.corners[i];
            const std::uint32_t vertex = vertices.first_at(corner.vertex);
            if (vertex == no_index) continue;
            mesh.tags.corners.push_back({vertex, corner.sharpness});
            corner_used_[i] = true;
        }
        if (creases_.empty()) return;
        for (const Polygon* face : faces) {
            const auto corners = polygons_.corners_of(*face);
            for (std::size_t i = 0; i < corners.size(); ++i)
                crease(corners[i].position, corners[(i + 1) % corners.size()].position, part, vertices, mesh);
        }
    }

    void note_unused(Diagnostics& diagnostics) const {
        const auto creases = std::count_if(creases_.begin(), creases_.end(),
                                           [](const auto& crease) { return crease.second.part == no_index; });
        const auto corners = std::count(corner_used_.begin(), corner_used_.end(), false);
        if (creases + corners > 0) {
            diagnostics.note(
                fmt::format("{} creases and {} corner tags are on no face and are left out.", creases, corners));
        }
    }

private:
    struct Tag {
        float sharpness = 0.0f;
        std::uint32_t part = no_index;  ///< the last one that got it
    };

    void crease(std::uint32_t a, std::uint32_t b, std::uint32_t part, const Vertices& vertices, Mesh& mesh) {
        const auto found = creases_.find(edge_key(a, b));
        if (found == creases_.end() || found->second.part == part) return;
        found->second.part = part;
        mesh.tags.creases.push_back({vertices.first_at(a), vertices.first_at(b), found->second.sharpness});
    }

    const Polygons& polygons_;
    std::unordered_map<std::uint64_t, Tag> creases_;
    std::vector<bool> corner_used_;
};

}  // namespace

std::vector<Mesh> make_meshes(const Polygons& polygons, const std::vector<std::uint32_t>& materials,
                              Diagnostics& diagnostics) {
    std::vector<std::vector<const Polygon*>> faces(polygons.parts.size());
    for (const Polygon& face : polygons.faces)
        faces[face.part].push_back(&face);
    TagGiver tags(polygons);
    std::vector<Mesh> meshes;
    for (std::uint32_t part = 0; part < faces.size(); ++part) {
        if (faces[part].empty()) continue;
        Mesh& mesh = meshes.emplace_back();
        mesh.name = polygons.parts[part].name.empty() ? "mesh" : polygons.parts[part].name;
        mesh.material = materials[part];
        Vertices vertices(polygons, mesh);
        for (const Polygon* face : faces[part]) {
            auto& indices = face->count == 3 ? mesh.triangles : mesh.quads;
            for (const Corner& corner : polygons.corners_of(*face))
                indices.push_back(vertices.place(corner));
        }
        tags.give(faces[part], part, vertices, mesh);
    }
    tags.note_unused(diagnostics);
    return meshes;
}

}  // namespace tessera::scene
