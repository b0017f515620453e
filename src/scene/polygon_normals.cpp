#include "scene/normals.hpp"
#include "scene/polygons.hpp"

#include <algorithm>
#include <unordered_map>

namespace tessera::scene {
namespace {

bool lacks_normal(const Corner& corner) {
    return corner.normal == no_index;
}

/// Faces of one smoothing group as a mesh of their own; one vertex per position used.
class Group {
public:
    void add(const Polygons& polygons, const Polygon& face) {
        auto& indices = face.count == 3 ? mesh_.triangles : mesh_.quads;
        for (const Corner& corner : polygons.corners_of(face)) {
            const auto [entry, is_new] =
                places_.try_emplace(corner.position, static_cast<std::uint32_t>(mesh_.positions.size()));
            if (is_new) {
                mesh_.positions.push_back(polygons.positions[corner.position]);
                mesh_.normals.emplace_back(0.0f);
            }
            indices.push_back(entry->second);
        }
    }

    /// Puts the group's normals behind the others.
    void compute(Polygons& polygons) {
        complete_normals({&mesh_, 1});
        first_ = static_cast<std::uint32_t>(polygons.normals.size());
        polygons.normals.insert(polygons.normals.end(), mesh_.normals.begin(), mesh_.normals.end());
    }

    std::uint32_t normal_at(std::uint32_t position) const { return first_ + places_.at(position); }

private:
    Mesh mesh_;
    std::unordered_map<std::uint32_t, std::uint32_t> places_;
    std::uint32_t first_ = 0;
};

}  // namespace

void flatten_normals(Polygons& polygons) {
    for (const Polygon& face : polygons.faces) {
        const std::span<Corner> corners = polygons.corners_of(face);
        if (face.smoothing != 0 || std::none_of(corners.begin(), corners.end(), lacks_normal)) continue;
        const glm::dvec3 area = vector_area(polygons, face);
        const double length = glm::length(area);
        const auto normal = static_cast<std::uint32_t>(polygons.normals.size());
        polygons.normals.push_back(length > 0.0 ? glm::vec3(area / length) + 0.0f : glm::vec3(0.0f, 0.0f, 1.0f));
        for (Corner& corner : corners) {
            if (lacks_normal(corner)) corner.normal = normal;
        }
    }
}

void complete_polygon_normals(Polygons& polygons) {
    flatten_normals(polygons);
    std::unordered_map<std::uint32_t, Group> groups;
    for (const Polygon& face : polygons.faces) {
        const auto corners = polygons.corners_of(face);
        if (std::any_of(corners.begin(), corners.end(), lacks_normal)) groups.try_emplace(face.smoothing);
    }
    // All faces of a group shape its normals, those with normals of their own too.
    for (const Polygon& face : polygons.faces) {
        const auto group = groups.find(face.smoothing);
        if (group != groups.end()) group->second.add(polygons, face);
    }
    for (auto& [smoothing, group] : groups)
        group.compute(polygons);
    for (const Polygon& face : polygons.faces) {
        const auto group = groups.find(face.smoothing);
        if (group == groups.end()) continue;
        for (Corner& corner : polygons.corners_of(face)) {
            if (lacks_normal(corner)) corner.normal = group->second.normal_at(corner.position);
        }
    }
}

}  // namespace tessera::scene
