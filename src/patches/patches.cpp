#include "patches/patches.hpp"

#include "base/error.hpp"
#include "patches/corner_attributes.hpp"
#include "patches/surface_tags.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace tessera::patches {
namespace {

constexpr float tiny = 0x1p-60f;

float flush(float x) {
    return std::fabs(x) < tiny ? 0.0f : x;
}

Vertex control_vertex(const scene::Mesh& mesh, std::size_t i, int exponent) {
    const glm::vec3& p = mesh.positions[i];
    const glm::vec3& n = mesh.normals[i];
    const glm::vec2& t = mesh.uvs[i];
    // A vertex that no face uses may lie far outside; no kernel shall meet an infinity.
    const auto scaled = [exponent](float x) { return flush(std::clamp(std::scalbn(x, -exponent), -2.0f, 2.0f)); };
    return {{scaled(p.x), scaled(p.y), scaled(p.z)}, {flush(n.x), flush(n.y), flush(n.z)}, {flush(t.x), flush(t.y)}};
}

}  // namespace

int scene_exponent(const scene::Scene& scene) {
    float largest = 0.0f;
    const auto see = [&largest](const glm::vec3& p) {
        largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    };
    for (const scene::Mesh& mesh : scene.meshes) {
        for (const std::vector<std::uint32_t>* indices : {&mesh.triangles, &mesh.quads}) {
            for (const std::uint32_t i : *indices)
                see(mesh.positions[i]);
        }
    }
    for (const scene::Guides& guides : scene.guides) {
        for (const glm::vec3& p : guides.points)
            see(p);
    }
    return largest > 0.0f ? std::ilogb(largest) : 0;
}

PatchSet make_patches(const scene::Scene& scene) {
    std::uint64_t vertex_count = 0;
    std::uint64_t patch_count = 0;
    for (const scene::Mesh& mesh : scene.meshes) {
        vertex_count += mesh.positions.size();
        patch_count += mesh.triangles.size() / 3 + mesh.quads.size() / 4;
    }
    if (patch_count == 0) {
        throw Error(ErrorKind::usage,
                    fmt::format("{} holds no triangles or quads, so there is nothing to tessellate.", scene.source));
    }
    if (vertex_count > 0xffffffffull) {
        throw Error(ErrorKind::usage, fmt::format("{} holds {} vertices, more than the 4294967295 that 32-bit indices "
                                                  "can address; split the model.",
                                                  scene.source, vertex_count));
    }
    PatchSet set;
    set.exponent = scene_exponent(scene);
    set.control_vertices.reserve(vertex_count);
    set.corners.reserve(patch_count);
    for (const scene::Mesh& mesh : scene.meshes) {
        const auto base = static_cast<std::uint32_t>(set.control_vertices.size());
        set.ranges.push_back(
            {mesh.name, mesh.material, set.patch_count(), mesh.triangles.size() / 3 + mesh.quads.size() / 4});
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            set.control_vertices.push_back(control_vertex(mesh, i, set.exponent));
        }
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
            const std::uint32_t* face = &mesh.triangles[i];
            set.corners.push_back({base + face[0], base + face[1], base + face[2], no_corner});
        }
        for (std::size_t i = 0; i < mesh.quads.size(); i += 4) {
            const std::uint32_t* face = &mesh.quads[i];
            set.corners.push_back({base + face[0], base + face[1], base + face[2], base + face[3]});
            set.has_quads = true;
        }
    }
    add_surface_tags(scene, set);
    add_corner_attributes(scene, set);
    return set;
}

float to_model_space(float coordinate, int exponent) {
    // A double holds every product; the one rounding is the conversion back, and only where the result is denormal.
    return static_cast<float>(std::scalbn(static_cast<double>(coordinate), exponent));
}

}  // namespace tessera::patches
