#include "scene/gltf_bake.hpp"

#include "scene/finite.hpp"
#include "scene/gltf_accessor.hpp"
#include "scene/gltf_skin.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tessera::scene {
namespace {

/// To float without the undefined behaviour of a value out of range, and without negative zeros: equal positions
/// then have equal bits.
float to_float(double value) {
    if (!(std::abs(value) <= std::numeric_limits<float>::max())) return std::numeric_limits<float>::infinity();
    return static_cast<float>(value) + 0.0f;
}

glm::vec3 to_float(const glm::dvec3& v) {
    return {to_float(v.x), to_float(v.y), to_float(v.z)};
}

/// The linear part scaled to a largest element of 1, so that its products neither overflow nor vanish.
glm::dmat3 scaled_linear(const glm::dmat4& transform) {
    glm::dmat3 linear(transform);
    double largest = 0.0;
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r)
            largest = std::max(largest, std::abs(linear[c][r]));
    }
    return largest > 0.0 && std::isfinite(largest) ? linear / largest : glm::dmat3(0.0);
}

/// The inverse transpose up to a positive factor: cofactors times the sign of the determinant. It exists for a
/// singular transform too, where it still gives the normal of a flattened surface.
struct NormalTransform {
    glm::dmat3 matrix;
    bool mirrors;
};

glm::dmat3 cofactors(const glm::dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

NormalTransform normal_transform(const glm::dmat4& transform) {
    const glm::dmat3 linear = scaled_linear(transform);
    const glm::dmat3 cofactor = cofactors(linear);
    const bool mirrors = glm::dot(linear[0], cofactor[0]) < 0.0;
    return {mirrors ? -cofactor : cofactor, mirrors};
}

glm::vec3 unit_or_zero(const glm::dvec3& v) {
    const double length = std::hypot(v.x, v.y, v.z);
    if (!(length > 0.0) || !std::isfinite(length)) return glm::vec3(0.0f);
    // A vector too short for its own quotients counts as none.
    const glm::vec3 unit = to_float(v / length);
    return finite(unit) ? unit : glm::vec3(0.0f);
}

void morph(const Document& document, const SourcePrimitive& source, const std::vector<double>& weights,
           std::vector<glm::dvec3>& positions, std::vector<glm::dvec3>& normals, std::vector<glm::dvec3>& tangents) {
    const auto add = [&](const std::map<std::string, int>& target, const char* name, double weight,
                         std::vector<glm::dvec3>& to) {
        const auto it = target.find(name);
        if (it == target.end()) return;
        const auto displacements = as_vec3(read_floats(document, it->second));
        for (std::size_t i = 0; i < to.size(); ++i)
            to[i] += weight * glm::dvec3(displacements[i]);
    };
    for (std::size_t t = 0; t < std::min(weights.size(), source.primitive->targets.size()); ++t) {
        if (weights[t] == 0.0) continue;
        add(source.primitive->targets[t], "POSITION", weights[t], positions);
        if (!normals.empty()) add(source.primitive->targets[t], "NORMAL", weights[t], normals);
        if (!tangents.empty()) add(source.primitive->targets[t], "TANGENT", weights[t], tangents);
    }
}

/// Drops triangles with a position that is not finite, then those vertices.
void drop_unsound(const Document& document, const SourcePrimitive& source, Mesh& mesh) {
    const std::size_t count = mesh.positions.size();
    std::vector<std::uint32_t> place(count);
    std::uint32_t kept = 0;
    for (std::size_t v = 0; v < count; ++v) {
        place[v] = kept;
        if (!finite(mesh.positions[v])) continue;
        mesh.positions[kept] = mesh.positions[v];
        mesh.normals[kept] = mesh.normals[v];
        mesh.uvs[kept] = mesh.uvs[v];
        if (!mesh.alphas.empty()) mesh.alphas[kept] = mesh.alphas[v];
        if (!mesh.stpn.empty()) mesh.stpn[kept] = mesh.stpn[v];
        if (!mesh.colors.empty()) mesh.colors[kept] = mesh.colors[v];
        if (!mesh.tangents.empty()) mesh.tangents[kept] = mesh.tangents[v];
        ++kept;
    }
    if (kept == count) return;
    const auto sound = [&](std::uint32_t v) { return (v + 1 < count ? place[v + 1] : kept) != place[v]; };
    std::size_t end = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const std::uint32_t a = mesh.triangles[i], b = mesh.triangles[i + 1], c = mesh.triangles[i + 2];
        if (!sound(a) || !sound(b) || !sound(c)) continue;
        mesh.triangles[end++] = place[a];
        mesh.triangles[end++] = place[b];
        mesh.triangles[end++] = place[c];
    }
    document.diagnostics.note(
        fmt::format("{}: {} positions are not finite; they are left out with the {} triangles "
                    "that use them.",
                    source.element, count - kept, (mesh.triangles.size() - end) / 3));
    mesh.positions.resize(kept);
    mesh.normals.resize(kept);
    mesh.uvs.resize(kept);
    if (!mesh.alphas.empty()) mesh.alphas.resize(kept);
    if (!mesh.stpn.empty()) mesh.stpn.resize(kept);
    if (!mesh.colors.empty()) mesh.colors.resize(kept);
    if (!mesh.tangents.empty()) mesh.tangents.resize(kept);
    mesh.triangles.resize(end);
}

/// Leaves out all tangents where one of them is of no use: they are then computed anew as a whole.
void drop_unusable_tangents(const Document& document, const SourcePrimitive& source, Mesh& mesh) {
    const auto unusable = std::ranges::count_if(
        mesh.tangents, [](const glm::vec4& t) { return glm::vec3(t) == glm::vec3(0.0f) || std::abs(t.w) != 1.0f; });
    if (unusable == 0) return;
    document.diagnostics.note(
        fmt::format("{}: {} tangents are zero, not finite or have a handedness that is not 1 or -1; all are left out.",
                    source.element, unusable));
    mesh.tangents.clear();
}

void note_normals(const Document& document, const SourcePrimitive& source) {
    std::size_t unusable = 0;
    std::size_t not_unit = 0;
    for (const glm::vec3& n : source.normals) {
        const double length = std::hypot(static_cast<double>(n.x), n.y, n.z);
        if (!(length > 0.0) || !std::isfinite(length)) {
            ++unusable;
        } else if (std::abs(length - 1.0) > 0.01 && !source.quantized_normals) {
            ++not_unit;
        }
    }
    if (unusable > 0) {
        document.diagnostics.note(
            fmt::format("{}: {} normals are zero or not finite and are computed from the "
                        "triangles.",
                        source.element, unusable));
    }
    if (not_unit > 0) {
        document.diagnostics.note(
            fmt::format("{}: {} normals are not of unit length and are normalised.", source.element, not_unit));
    }
}

}  // namespace

bool keeps_surfaces(const glm::dmat4& transform) {
    const glm::dmat3 cofactor = cofactors(scaled_linear(transform));
    return cofactor != glm::dmat3(0.0);
}

Mesh bake(const Document& document, const SourcePrimitive& source, const Pose& pose) {
    const std::size_t count = source.positions.size();
    std::vector<glm::dvec3> positions(source.positions.begin(), source.positions.end());
    std::vector<glm::dvec3> normals(source.normals.begin(), source.normals.end());
    std::vector<glm::dvec3> tangents(source.tangents.begin(), source.tangents.end());
    morph(document, source, pose.morph_weights, positions, normals, tangents);
    note_normals(document, source);

    const bool skinned = !pose.joints.empty() && source.influences > 0;
    if (skinned) check_influences(document, source, pose.joints.size());
    glm::dmat4 transform = pose.world;
    NormalTransform for_normals = normal_transform(transform);

    Mesh mesh;
    mesh.positions.resize(count);
    mesh.normals.resize(count, glm::vec3(0.0f));
    mesh.uvs = source.uvs;
    mesh.alphas = source.alphas;
    mesh.stpn = source.stpn;
    mesh.colors = source.colors;
    mesh.tangents = source.tangents;
    mesh.triangles = source.triangles;
    std::size_t mirrored = 0;
    for (std::size_t v = 0; v < count; ++v) {
        if (skinned) {
            transform = blended_matrix(source, pose.joints, v);
            for_normals = normal_transform(transform);
        }
        mirrored += for_normals.mirrors ? 1 : 0;
        mesh.positions[v] = to_float(glm::dvec3(transform * glm::dvec4(positions[v], 1.0)));
        if (!normals.empty()) mesh.normals[v] = unit_or_zero(for_normals.matrix * normals[v]);
        if (!tangents.empty()) {
            // A mirror turns the bitangent round against the cross product.
            const float w = source.tangents[v].w;
            mesh.tangents[v] = {unit_or_zero(scaled_linear(transform) * tangents[v]), for_normals.mirrors ? -w : w};
        }
    }
    // A skin's joints mirror together or not at all; were they to disagree, most of the vertices decide.
    if (2 * mirrored > count) {
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
            std::swap(mesh.triangles[i + 1], mesh.triangles[i + 2]);
    }
    drop_unusable_tangents(document, source, mesh);
    drop_unsound(document, source, mesh);
    return mesh;
}

}  // namespace tessera::scene
