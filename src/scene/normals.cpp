#include "scene/normals.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <unordered_map>

namespace tessera::scene {
namespace {

struct PositionHash {
    std::size_t operator()(const glm::vec3& p) const {
        std::uint64_t hash = 0;
        for (int i = 0; i < 3; ++i)
            hash = (hash ^ std::bit_cast<std::uint32_t>(p[i])) * 0x9e3779b97f4a7c15u;
        return hash ^ (hash >> 29);
    }
};

bool is_missing(const glm::vec3& n) {
    return n == glm::vec3(0.0f);
}

/// The angle between two edges, safe for nearly parallel ones.
double angle(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

using Sums = std::unordered_map<glm::vec3, glm::dvec3, PositionHash>;

/// The direction a face looks into. For a quad that of the cross product of its diagonals, its vector area.
template <std::size_t N>
glm::dvec3 face_normal(const glm::dvec3 (&corner)[N]) {
    if constexpr (N == 3) return glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    return glm::cross(corner[2] - corner[0], corner[N - 1] - corner[1]);
}

template <std::size_t N>
void add_face(const Mesh& mesh, const std::uint32_t* indices, Sums& sums) {
    glm::dvec3 corner[N];
    Sums::iterator sum[N];
    bool wanted = false;
    for (std::size_t i = 0; i < N; ++i) {
        const glm::vec3& position = mesh.positions[indices[i]];
        corner[i] = position;
        sum[i] = sums.find(position);
        wanted = wanted || sum[i] != sums.end();
    }
    if (!wanted) return;
    // Positions are floats, so squares of their differences fit a double with room to spare at either end.
    const glm::dvec3 normal = face_normal(corner);
    const double length = glm::length(normal);
    if (!(length > 0.0)) return;
    for (std::size_t i = 0; i < N; ++i) {
        if (sum[i] == sums.end()) continue;
        sum[i]->second += normal / length * angle(corner[(i + 1) % N] - corner[i], corner[(i + N - 1) % N] - corner[i]);
    }
}

glm::vec3 unit(const glm::dvec3& sum) {
    const double length = glm::length(sum);
    // Opposite faces may cancel but for rounding; what is left then points nowhere in particular.
    if (!(length > 1e-12)) return {0.0f, 0.0f, 1.0f};
    return glm::vec3(sum / length) + 0.0f;
}

}  // namespace

void complete_normals(std::span<Mesh> meshes) {
    Sums sums;
    for (const Mesh& mesh : meshes) {
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            if (is_missing(mesh.normals[v])) sums.emplace(mesh.positions[v], glm::dvec3(0.0));
        }
    }
    if (sums.empty()) return;
    for (const Mesh& mesh : meshes) {
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
            add_face<3>(mesh, &mesh.triangles[i], sums);
        for (std::size_t i = 0; i < mesh.quads.size(); i += 4)
            add_face<4>(mesh, &mesh.quads[i], sums);
    }
    for (Mesh& mesh : meshes) {
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            if (is_missing(mesh.normals[v])) mesh.normals[v] = unit(sums.at(mesh.positions[v]));
        }
    }
}

}  // namespace tessera::scene
