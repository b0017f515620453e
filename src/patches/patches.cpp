#include "patches/patches.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <tuple>

namespace tessera::patches {
namespace {

constexpr float tiny = 0x1p-60f;

float flush(float x) { return std::fabs(x) < tiny ? 0.0f : x; }

int largest_exponent(const scene::Scene& scene) {
    float largest = 0.0f;
    for (const scene::Mesh& mesh : scene.meshes) {
        for (const glm::vec3& p : mesh.positions) {
            largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
        }
    }
    return largest > 0.0f ? std::ilogb(largest) : 0;
}

Vertex control_vertex(const scene::Mesh& mesh, std::size_t i, int exponent) {
    const glm::vec3& p = mesh.positions[i];
    const glm::vec3& n = mesh.normals[i];
    const glm::vec2& t = mesh.uvs[i];
    const auto scaled = [exponent](float x) { return flush(std::scalbn(x, -exponent)); };
    return {{scaled(p.x), scaled(p.y), scaled(p.z)}, {flush(n.x), flush(n.y), flush(n.z)}, {flush(t.x), flush(t.y)}};
}

bool lexicographically_less(const glm::vec3& a, const glm::vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

double squared_distance(const glm::vec3& a, const glm::vec3& b) {
    const glm::dvec3 d = glm::dvec3(a) - glm::dvec3(b);
    return d.x * d.x + d.y * d.y + d.z * d.z;
}

// Two triangles over the shorter diagonal. Where both are as long, the one with the smallest corner position: the same
// choice however the quad is turned or numbered.
std::array<std::uint32_t, 6> halves(const scene::Mesh& mesh, const std::uint32_t* quad) {
    const auto at = [&](int i) -> const glm::vec3& { return mesh.positions[quad[i]]; };
    const auto smaller = [&](int i, int k) -> const glm::vec3& {
        return lexicographically_less(at(k), at(i)) ? at(k) : at(i);
    };
    const double first = squared_distance(at(0), at(2));
    const double second = squared_distance(at(1), at(3));
    if (second < first || (second == first && lexicographically_less(smaller(1, 3), smaller(0, 2)))) {
        return {quad[0], quad[1], quad[3], quad[1], quad[2], quad[3]};
    }
    return {quad[0], quad[1], quad[2], quad[0], quad[2], quad[3]};
}

}  // namespace

PatchSet make_patches(const scene::Scene& scene) {
    std::uint64_t vertex_count = 0;
    std::uint64_t index_count = 0;
    for (const scene::Mesh& mesh : scene.meshes) {
        vertex_count += mesh.positions.size();
        index_count += mesh.triangles.size() + mesh.quads.size() / 4 * 6;
    }
    if (index_count == 0) {
        throw Error(ErrorKind::usage, fmt::format("{} holds no triangles or quads, so there is nothing to tessellate.",
                                                  scene.source));
    }
    if (vertex_count > 0xffffffffull) {
        throw Error(ErrorKind::usage, fmt::format("{} holds {} vertices, more than the 4294967295 that 32-bit indices "
                                                  "can address; split the model.", scene.source, vertex_count));
    }
    PatchSet set;
    set.exponent = largest_exponent(scene);
    set.control_vertices.reserve(vertex_count);
    set.indices.reserve(index_count);
    for (const scene::Mesh& mesh : scene.meshes) {
        const auto base = static_cast<std::uint32_t>(set.control_vertices.size());
        set.ranges.push_back({mesh.name, mesh.material, set.patch_count(), mesh.triangles.size() / 3 + mesh.quads.size() / 4 * 2});
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            set.control_vertices.push_back(control_vertex(mesh, i, set.exponent));
        }
        for (const std::uint32_t index : mesh.triangles) {
            set.indices.push_back(base + index);
        }
        for (std::size_t i = 0; i < mesh.quads.size(); i += 4) {
            for (const std::uint32_t index : halves(mesh, &mesh.quads[i])) {
                set.indices.push_back(base + index);
            }
        }
    }
    return set;
}

float to_model_space(float coordinate, int exponent) {
    // A double holds every product; the one rounding is the conversion back, and only where the result is denormal.
    return static_cast<float>(std::scalbn(static_cast<double>(coordinate), exponent));
}

}  // namespace tessera::patches
