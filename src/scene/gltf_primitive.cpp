#include "scene/gltf_primitive.hpp"

#include "scene/gltf_accessor.hpp"
#include "scene/gltf_guides.hpp"
#include "scene/gltf_maps.hpp"
#include "scene/gltf_shape_tags.hpp"
#include "scene/gltf_vertex_attributes.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace tessera::scene {
namespace {

constexpr int max_influence_sets = 4;

int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
    const auto it = primitive.attributes.find(name);
    return it == primitive.attributes.end() ? -1 : it->second;
}

void read_uvs(const Document& document, SourcePrimitive& out) {
    out.uvs.resize(out.positions.size(), glm::vec2(0.0f));
    const UvSource source = uv_source(document, out.primitive->material);
    const int accessor = attribute(*out.primitive, fmt::format("TEXCOORD_{}", source.set));
    if (accessor < 0) {
        if (source.textured) {
            document.diagnostics.note(
                fmt::format("{} has a texture, but no TEXCOORD_{} to place it with.", out.element, source.set));
        }
        return;
    }
    const std::vector<float> numbers = read_floats(document, accessor);
    std::size_t unsound = 0;
    bool outside = false;
    for (std::size_t i = 0; i < out.uvs.size(); ++i) {
        const auto uv = glm::vec2(source.transform * glm::dvec3(numbers[2 * i], numbers[2 * i + 1], 1.0));
        if (std::isfinite(uv.x) && std::isfinite(uv.y)) {
            out.uvs[i] = uv;
            outside = outside || uv.x < 0.0f || uv.x > 1.0f || uv.y < 0.0f || uv.y > 1.0f;
        } else {
            ++unsound;
        }
    }
    if (unsound > 0) {
        document.diagnostics.note(
            fmt::format("{}: {} texture coordinates are not finite and became zero.", out.element, unsound));
    }
    if (outside && !source.repeats) {
        document.diagnostics.note(
            fmt::format("{}: its texture is repeated beyond [0, 1], where the file would clamp "
                        "or mirror it.",
                        out.element));
    }
}

void read_influences(const Document& document, SourcePrimitive& out) {
    std::vector<std::pair<int, int>> sets;
    for (int set = 0;; ++set) {
        const int joints = attribute(*out.primitive, fmt::format("JOINTS_{}", set));
        const int weights = attribute(*out.primitive, fmt::format("WEIGHTS_{}", set));
        if ((joints < 0) != (weights < 0)) {
            document.diagnostics.refuse(fmt::format("{}.attributes", out.element),
                                        fmt::format("has only one of JOINTS_{0} and WEIGHTS_{0}", set));
        }
        if (joints < 0) break;
        if (set == max_influence_sets) {
            document.diagnostics.refuse(fmt::format("{}.attributes", out.element),
                                        fmt::format("has more than the {} supported sets of joints", set));
        }
        sets.emplace_back(joints, weights);
    }
    out.influences = 4 * sets.size();
    out.joints.resize(out.influences * out.positions.size());
    out.weights.resize(out.joints.size());
    for (std::size_t s = 0; s < sets.size(); ++s) {
        const auto joints = read_unsigned(document, sets[s].first);
        const auto weights = read_floats(document, sets[s].second);
        for (std::size_t i = 0; i < joints.size(); ++i) {
            const std::size_t to = i / 4 * out.influences + 4 * s + i % 4;
            out.joints[to] = joints[i];
            out.weights[to] = weights[i];
        }
    }
}

std::vector<std::uint32_t> read_indices(const Document& document, const SourcePrimitive& out) {
    if (out.primitive->indices < 0) {
        std::vector<std::uint32_t> indices(out.positions.size());
        std::iota(indices.begin(), indices.end(), 0u);
        return indices;
    }
    auto indices = read_unsigned(document, out.primitive->indices);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] >= out.positions.size()) {
            document.diagnostics.refuse(out.element + ".indices",
                                        fmt::format("holds {} at place {}, but there are only {} vertices", indices[i],
                                                    i, out.positions.size()));
        }
    }
    return indices;
}

/// Removes triangles that name a vertex twice and returns how many there were.
std::size_t drop_collapsed(std::vector<std::uint32_t>& triangles) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const std::uint32_t a = triangles[i], b = triangles[i + 1], c = triangles[i + 2];
        if (a == b || b == c || c == a) continue;
        triangles[kept++] = a;
        triangles[kept++] = b;
        triangles[kept++] = c;
    }
    const std::size_t dropped = (triangles.size() - kept) / 3;
    triangles.resize(kept);
    return dropped;
}

void read_triangles(const Document& document, SourcePrimitive& out) {
    const int mode = out.primitive->mode;
    const auto indices = read_indices(document, out);
    if (mode == TINYGLTF_MODE_LINE || mode == TINYGLTF_MODE_LINE_STRIP) {
        read_guides(document, indices, out);
        return;
    }
    if (mode < TINYGLTF_MODE_TRIANGLES) {
        document.diagnostics.note(fmt::format("{} is made of {}, which are skipped.", out.element,
                                              mode == TINYGLTF_MODE_POINTS ? "points" : "lines"));
        return;
    }
    out.triangles = to_triangle_list(mode, indices);
    if (mode == TINYGLTF_MODE_TRIANGLES && indices.size() % 3 != 0) {
        document.diagnostics.note(fmt::format("{} has {} indices, not a multiple of three: the rest is skipped.",
                                              out.element, indices.size()));
    }
    // Strips use collapsed triangles on purpose, to jump.
    const std::size_t dropped = drop_collapsed(out.triangles);
    if (dropped > 0 && mode == TINYGLTF_MODE_TRIANGLES) {
        document.diagnostics.note(
            fmt::format("{}: {} triangles that name a vertex twice are skipped.", out.element, dropped));
    }
}

}  // namespace

std::vector<glm::vec3> as_vec3(std::span<const float> numbers) {
    std::vector<glm::vec3> out(numbers.size() / 3);
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
    return out;
}

std::vector<std::uint32_t> to_triangle_list(int mode, std::span<const std::uint32_t> indices) {
    std::vector<std::uint32_t> out;
    if (indices.size() < 3) return out;
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        out.assign(indices.begin(), indices.begin() + static_cast<std::ptrdiff_t>(indices.size() / 3 * 3));
        return out;
    }
    out.reserve((indices.size() - 2) * 3);
    for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
        if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
            // Every second triangle of a strip runs the other way round.
            out.insert(out.end(), {indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
        } else {
            out.insert(out.end(), {indices[i + 1], indices[i + 2], indices[0]});
        }
    }
    return out;
}

SourcePrimitive read_primitive(const Document& document, std::size_t mesh, std::size_t index) {
    SourcePrimitive out;
    out.element = fmt::format("meshes[{}].primitives[{}]", mesh, index);
    out.primitive = &document.model.meshes[mesh].primitives[index];
    const int position = attribute(*out.primitive, "POSITION");
    if (position < 0) {
        document.diagnostics.note(fmt::format("{} has no POSITION and is skipped.", out.element));
        return out;
    }
    out.positions = as_vec3(read_floats(document, position));
    read_triangles(document, out);
    if (const int normal = attribute(*out.primitive, "NORMAL"); normal >= 0) {
        out.normals = as_vec3(read_floats(document, normal));
        out.quantized_normals =
            document.model.accessors[static_cast<std::size_t>(normal)].componentType != TINYGLTF_COMPONENT_TYPE_FLOAT;
    }
    if (out.guide_ends.empty()) read_uvs(document, out);  // hair has its own: across and along
    read_shape_tags(document, document.model.meshes[mesh], out);
    if (out.guide_ends.empty()) read_vertex_attributes(document, out);
    read_influences(document, out);
    return out;
}

}  // namespace tessera::scene
