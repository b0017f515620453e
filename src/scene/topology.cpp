#include "scene/topology.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstring>
#include <numeric>
#include <vector>

namespace tessera::scene {
namespace {

/// The same number for vertices at the same position.
std::vector<std::uint32_t> number_positions(std::span<const Mesh> meshes) {
    std::vector<glm::vec3> positions;
    for (const Mesh& mesh : meshes)
        positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
    const auto compare = [&](std::uint32_t a, std::uint32_t b) {
        return std::memcmp(&positions[a], &positions[b], sizeof(glm::vec3));
    };
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return compare(a, b) < 0; });
    std::vector<std::uint32_t> numbers(positions.size());
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        next += i > 0 && compare(order[i - 1], order[i]) != 0 ? 1u : 0u;
        numbers[order[i]] = next;
    }
    return numbers;
}

/// Calls visit(indices, count) for every face.
template <typename Visit>
void for_each_face(const Mesh& mesh, Visit visit) {
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
        visit(&mesh.triangles[i], std::size_t{3});
    for (std::size_t i = 0; i < mesh.quads.size(); i += 4)
        visit(&mesh.quads[i], std::size_t{4});
}

}  // namespace

std::size_t count_unused_vertices(const Mesh& mesh) {
    std::vector<bool> used(mesh.positions.size());
    for_each_face(mesh, [&](const std::uint32_t* corners, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k)
            used[corners[k]] = true;
    });
    return static_cast<std::size_t>(std::ranges::count(used, false));
}

std::size_t count_crowded_edges(std::span<const Mesh> meshes) {
    const std::vector<std::uint32_t> number = number_positions(meshes);
    std::vector<std::uint64_t> edges;
    std::size_t base = 0;
    for (const Mesh& mesh : meshes) {
        for_each_face(mesh, [&](const std::uint32_t* corners, std::size_t count) {
            for (std::size_t k = 0; k < count; ++k) {
                const std::uint32_t a = number[base + corners[k]];
                const std::uint32_t b = number[base + corners[(k + 1) % count]];
                if (a != b) edges.push_back(std::uint64_t{std::min(a, b)} << 32 | std::max(a, b));
            }
        });
        base += mesh.positions.size();
    }
    std::ranges::sort(edges);
    std::size_t crowded = 0;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i;
        while (end < edges.size() && edges[end] == edges[i])
            ++end;
        crowded += end - i > 2 ? 1 : 0;
        i = end;
    }
    return crowded;
}

std::size_t count_flat_faces(std::span<const Mesh> meshes) {
    std::size_t flat = 0;
    for (const Mesh& mesh : meshes) {
        for_each_face(mesh, [&](const std::uint32_t* corners, std::size_t count) {
            // No corner and its two neighbours span anything. Differences of floats are exact enough in double for a
            // cross product to vanish where they are parallel but for rounding of the file's own.
            bool spans = false;
            for (std::size_t k = 0; k < count; ++k) {
                const glm::dvec3 at(mesh.positions[corners[k]]);
                const glm::dvec3 a = glm::dvec3(mesh.positions[corners[(k + 1) % count]]) - at;
                const glm::dvec3 b = glm::dvec3(mesh.positions[corners[(k + count - 1) % count]]) - at;
                spans = spans || glm::cross(a, b) != glm::dvec3(0.0);
            }
            flat += spans ? 0 : 1;
        });
    }
    return flat;
}

void note_unused_vertices(std::size_t count, Diagnostics& diagnostics) {
    if (count > 0) diagnostics.note(fmt::format("{} vertices are used by no face.", count));
}

void note_crowded_edges(std::size_t count, Diagnostics& diagnostics) {
    if (count == 0) return;
    diagnostics.note(
        fmt::format("{} edges are used by more than two faces (the surface is not a manifold there).", count));
}

void note_flat_faces(std::size_t count, Diagnostics& diagnostics) {
    if (count > 0) diagnostics.note(fmt::format("{} faces have no area; they are kept.", count));
}

}  // namespace tessera::scene
