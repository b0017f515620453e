#include "patches/corner_attributes.hpp"

#include "patches/mikktspace.hpp"

#include <algorithm>
#include <cmath>

namespace tessera::patches {
namespace {

const scene::Map* normal_map(const scene::Scene& scene, const scene::Mesh& mesh) {
    if (mesh.material >= scene.materials.size()) return nullptr;
    const auto& map = scene.materials[mesh.material].maps.normal;
    return map ? &*map : nullptr;
}

/// Numbers whose products in a kernel could be denormal are zero.
void put(const glm::vec4& from, float (&to)[4]) {
    for (int i = 0; i < 4; ++i)
        to[i] = std::fabs(from[i]) < 0x1p-60f ? 0.0f : from[i];
}

/// Visits the corners of the patches of a range: patch, corner, and the vertex's number in its mesh.
template <typename Visit>
void for_each_corner(const PatchSet& set, const PatchRange& range, std::uint32_t first_vertex, Visit visit) {
    for (std::uint64_t patch = range.first_patch; patch < range.first_patch + range.patch_count; ++patch) {
        for (std::size_t c = 0; c < (is_quad(set.corners[patch]) ? 4u : 3u); ++c)
            visit(patch, c, set.corners[patch][c] - first_vertex);
    }
}

}  // namespace

void add_corner_attributes(const scene::Scene& scene, PatchSet& set) {
    const bool any = std::ranges::any_of(scene.meshes, [&](const scene::Mesh& mesh) {
        return !mesh.colors.empty() || normal_map(scene, mesh) != nullptr;
    });
    if (!any) return;
    set.corner_attributes.resize(set.corners.size());
    std::uint32_t first_vertex = 0;
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const scene::Mesh& mesh = scene.meshes[m];
        const PatchRange& range = set.ranges[m];
        if (!mesh.colors.empty()) {
            set.has_colors = true;
            for_each_corner(set, range, first_vertex, [&](std::uint64_t patch, std::size_t c, std::uint32_t vertex) {
                put(mesh.colors[vertex], set.corner_attributes[patch][c].color);
            });
        }
        const scene::Map* map = normal_map(scene, mesh);
        if (map != nullptr && !mesh.tangents.empty()) {
            for_each_corner(set, range, first_vertex, [&](std::uint64_t patch, std::size_t c, std::uint32_t vertex) {
                put(mesh.tangents[vertex], set.corner_attributes[patch][c].tangent);
            });
        } else if (map != nullptr) {
            const auto faces = std::span(set.corners).subspan(range.first_patch, range.patch_count);
            const auto tangents = corner_tangents(set.control_vertices, faces, map->transform);
            for_each_corner(set, range, first_vertex, [&](std::uint64_t patch, std::size_t c, std::uint32_t) {
                put(tangents[patch - range.first_patch][c], set.corner_attributes[patch][c].tangent);
            });
        }
        first_vertex += static_cast<std::uint32_t>(mesh.positions.size());
    }
}

}  // namespace tessera::patches
