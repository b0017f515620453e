#include "scene/shapes.hpp"

#include "base/error.hpp"
#include "scene/diagnostics.hpp"

#include <fmt/format.h>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace tessera::scene {
namespace {

constexpr std::string_view prefix = "shape:";
constexpr std::string_view sphere_prefix = "sphere:";
constexpr int most_segments = 256;

void add_vertex(Mesh& mesh, const glm::dvec3& position, const glm::dvec3& direction, const glm::dvec2& uv) {
    // Adding zero turns negative zeros into positive ones.
    mesh.positions.push_back(glm::vec3(position) + 0.0f);
    mesh.normals.push_back(glm::vec3(glm::normalize(direction)) + 0.0f);
    mesh.uvs.emplace_back(uv);
}

/// Five strips of four triangles, each a gore of the sphere: 22 vertices for 12 positions.
Mesh icosahedron() {
    Mesh mesh;
    const double height = 1.0 / std::sqrt(5.0);
    const double radius = 2.0 * height;
    const auto ring = [&](int i, double half) {
        const double angle = 2.0 * std::numbers::pi * (i % 5 + half) / 5.0;
        return glm::dvec3(radius * std::cos(angle), half == 0.0 ? height : -height, -radius * std::sin(angle));
    };
    const auto add = [&](const glm::dvec3& p, double u, double v) { add_vertex(mesh, p, p, {u, v}); };
    for (int i = 0; i < 5; ++i)
        add({0.0, 1.0, 0.0}, (i + 0.5) / 5.5, 0.0);  // 0..4
    for (int i = 0; i < 6; ++i)
        add(ring(i, 0.0), i / 5.5, 1.0 / 3.0);  // 5..10
    for (int i = 0; i < 6; ++i)
        add(ring(i, 0.5), (i + 0.5) / 5.5, 2.0 / 3.0);  // 11..16
    for (int i = 0; i < 5; ++i)
        add({0.0, -1.0, 0.0}, (i + 1.0) / 5.5, 1.0);  // 17..21
    for (std::uint32_t i = 0; i < 5; ++i) {
        const std::uint32_t upper = 5 + i;
        const std::uint32_t lower = 11 + i;
        const auto strip = {i,         upper, upper + 1, upper, lower,  upper + 1,
                            upper + 1, lower, lower + 1, lower, 17 + i, lower + 1};
        mesh.triangles.insert(mesh.triangles.end(), strip.begin(), strip.end());
    }
    return mesh;
}

Mesh cube() {
    Mesh mesh;
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const double side = face % 2 == 0 ? 1.0 : -1.0;
        glm::dvec3 normal(0.0), right(0.0);
        normal[axis] = side;
        right[(axis + 1) % 3] = side;
        const glm::dvec3 up = glm::cross(normal, right);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        constexpr std::array<glm::dvec2, 4> corners{glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}};
        for (const glm::dvec2& c : corners) {
            const glm::dvec3 p = normal + right * c.x + up * c.y;
            add_vertex(mesh, p, p, {(1.0 + c.x) / 2.0, (1.0 - c.y) / 2.0});
        }
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
            mesh.triangles.push_back(first + corner);
    }
    return mesh;
}

Mesh torus() {
    constexpr int around = 12;
    constexpr int across = 8;
    constexpr double ring_radius = 1.0;
    constexpr double tube_radius = 0.4;
    Mesh mesh;
    for (int i = 0; i <= around; ++i) {
        // The seam's angle is that of its other side, not 2 pi, for equal bits.
        const double ring = 2.0 * std::numbers::pi * (i % around) / around;
        const glm::dvec3 outward(std::cos(ring), 0.0, -std::sin(ring));
        for (int j = 0; j <= across; ++j) {
            const double tube = 2.0 * std::numbers::pi * (j % across) / across;
            const glm::dvec3 normal = outward * std::cos(tube) + glm::dvec3(0.0, std::sin(tube), 0.0);
            add_vertex(mesh, outward * ring_radius + normal * tube_radius, normal,
                       {static_cast<double>(i) / around, 1.0 - static_cast<double>(j) / across});
        }
    }
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t j = 0; j < across; ++j) {
            const std::uint32_t a = i * (across + 1) + j;
            const std::uint32_t b = a + across + 1;
            const auto quad = {a, b, b + 1, a, b + 1, a + 1};
            mesh.triangles.insert(mesh.triangles.end(), quad.begin(), quad.end());
        }
    }
    return mesh;
}

/// One face of the octahedron: `quarter` of a turn around y, upper or lower half. A vertex comes from three integers
/// that the neighbouring faces have too, so the faces meet to the bit.
void add_sphere_face(Mesh& mesh, int segments, int quarter, bool upper) {
    const std::array<glm::ivec2, 4> axes{
        glm::ivec2(1, 0), {0, -1}, {-1, 0}, {0, 1}};  // x, z: counter-clockwise seen from +y
    const glm::ivec2 from = axes[static_cast<std::size_t>(quarter)];
    const glm::ivec2 to = axes[static_cast<std::size_t>((quarter + 1) % 4)];
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int row = 0; row <= segments; ++row) {
        const int y = upper ? segments - row : row - segments;
        for (int i = 0; i <= row; ++i) {
            const glm::ivec2 xz = from * (row - i) + to * i;
            const glm::dvec3 p = glm::normalize(glm::dvec3(xz.x, y, xz.y));
            // At the pole any longitude would do: the middle of the face.
            const double turn = row == 0 ? 0.5 : std::atan2(i, row - i) * 2.0 / std::numbers::pi;
            add_vertex(mesh, p, p, {(quarter + turn) / 4.0, std::acos(p.y) / std::numbers::pi});
        }
    }
    const auto at = [&](int row, int i) { return first + static_cast<std::uint32_t>(row * (row + 1) / 2 + i); };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.triangles.insert(mesh.triangles.end(), {a, upper ? b : c, upper ? c : b});
    };
    for (int row = 0; row < segments; ++row) {
        for (int i = 0; i <= row; ++i) {
            add(at(row, i), at(row + 1, i), at(row + 1, i + 1));
            if (i < row) add(at(row, i), at(row + 1, i + 1), at(row, i + 1));
        }
    }
}

Mesh sphere(int segments) {
    Mesh mesh;
    for (int quarter = 0; quarter < 4; ++quarter) {
        add_sphere_face(mesh, segments, quarter, true);
        add_sphere_face(mesh, segments, quarter, false);
    }
    return mesh;
}

Mesh make_mesh(std::string_view name) {
    const std::string_view shape = name.substr(prefix.size());
    if (shape == "icosahedron") return icosahedron();
    if (shape == "cube") return cube();
    if (shape == "torus") return torus();
    if (shape.substr(0, sphere_prefix.size()) == sphere_prefix) {
        const std::string_view number = shape.substr(sphere_prefix.size());
        int segments = 0;
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), segments);
        const bool whole = error == std::errc() && end == number.data() + number.size();
        if (whole && segments >= 1 && segments <= most_segments) return sphere(segments);
        throw Error(ErrorKind::usage, fmt::format("{}: N must be a number of segments from 1 to {}, as in "
                                                  "shape:sphere:16.",
                                                  in_quotes(name), most_segments));
    }
    throw Error(ErrorKind::usage, fmt::format("There is no shape {}; there are shape:icosahedron, shape:cube, "
                                              "shape:torus and shape:sphere:N with N from 1 to {}.",
                                              in_quotes(name), most_segments));
}

}  // namespace

bool is_shape(std::string_view name) {
    return name.substr(0, prefix.size()) == prefix;
}

Scene make_shape(std::string_view name) {
    Scene scene;
    scene.source = name;
    scene.meshes.push_back(make_mesh(name));
    scene.meshes.back().name = name.substr(prefix.size());
    Material material;
    material.name = "default";
    scene.materials.push_back(std::move(material));
    return scene;
}

}  // namespace tessera::scene
