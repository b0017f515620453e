// A scene as kernels want it: control vertices and triangle patches, scaled so that no arithmetic meets a denormal.
#pragma once

#include "base/vertex.hpp"
#include "base/vertex_attributes.hpp"
#include "scene/scene.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tessera::patches {

/// The patches made from one mesh of the scene.
struct PatchRange {
    std::string name;
    std::uint32_t material = 0;
    std::uint64_t first_patch = 0;
    std::uint64_t patch_count = 0;
};

/// Stands for the fourth corner of a triangle.
inline constexpr std::uint32_t no_corner = 0xffffffffu;

/// Four control vertices around a face; the fourth of a triangle is no_corner.
using PatchCorners = std::array<std::uint32_t, 4>;

inline bool is_quad(const PatchCorners& corners) {
    return corners[3] != no_corner;
}

/// What shapes the surface at a control vertex, for the schemes phong and stpn, as the kernels lay it out.
struct VertexTags {
    float sharpness = 0.0f;  ///< 0 smooth, 1 sharp
    float bias = 0.0f;       ///< -1 .. 1: less or more bulge
    float tension = 0.0f;    ///< -1 .. 1: looser or tighter
    float alpha = -1.0f;     ///< of Phong tessellation, 0 .. 1; negative: what the job's options say
    float crease[3]{};       ///< unit, along the crease that runs through the vertex; zero where none does
    float normal[3]{};       ///< unit where a crease touches the vertex: smooth over all faces at its position
};
static_assert(sizeof(VertexTags) == 40);

/// Of a patch's corner, for the scheme stpn, as the kernels lay it out.
struct CornerTags {
    float normal[3]{};  ///< unit, split at creases
    float edge = 0.0f;  ///< sharpness of the edge from this corner to the next: 0 smooth, 1 sharp
};
static_assert(sizeof(CornerTags) == 16);

/// Triangle and quad patches over shared control vertices, in the order of the scene's meshes; of each mesh, triangles
/// before quads.
struct PatchSet {
    std::vector<Vertex> control_vertices;  ///< positions times 2^-exponent
    std::vector<PatchCorners> corners;     ///< of each patch
    bool has_quads = false;
    std::vector<VertexTags> vertex_tags;                 ///< of each control vertex, or none at all
    std::vector<std::array<CornerTags, 4>> corner_tags;  ///< of each patch, or none at all: where there are creases
    /// Of each patch, or none at all: where a mesh has colours or a normal map. They vary linearly (triangles) or
    /// bilinearly (quads) over a patch.
    std::vector<std::array<VertexAttributes, 4>> corner_attributes;
    bool has_colors = false;  ///< whether a mesh of the scene has colours
    std::vector<PatchRange> ranges;
    /// The largest coordinate of the faces lies in [2^exponent, 2^(exponent+1)); output positions are scaled back by
    /// 2^exponent, exactly.
    int exponent = 0;

    std::uint64_t patch_count() const { return corners.size(); }
};

/// The exponent of a scene's largest coordinate, guides of hair included: see PatchSet::exponent. 0 for a scene
/// without.
int scene_exponent(const scene::Scene& scene);

/// Scales by a power of two until the largest coordinate lies in [1, 2) (exact), and replaces magnitudes under 2^-60
/// by zero: some devices flush denormals, others keep them, so that they must not arise in a kernel. Vertices that no
/// face uses do not count; their coordinates are clamped to [-2, 2].
/// Tangents that a normal map needs and the scene has not are computed.
/// Throws Error(usage) where there is nothing to tessellate or more than 2^32 - 1 control vertices.
PatchSet make_patches(const scene::Scene& scene);

/// A position of kernel space in the model's units; exact unless the result is denormal or overflows.
float to_model_space(float coordinate, int exponent);

}  // namespace tessera::patches
