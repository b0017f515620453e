// Cuts a mesh of any size into pieces of bounded size.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "tessellate/refined_mesh.hpp"

namespace tessera::render {

/// A run of triangles, and the range of vertices that they use.
struct TriangleBatch {
    static constexpr std::size_t max_triangles = std::size_t{1} << 17;

    std::span<const std::uint32_t> indices;  ///< three per triangle
    std::uint32_t first_vertex = 0;          ///< the smallest index
    std::uint64_t vertex_count = 0;          ///< up to the largest index

    /// True where uploading the range is no more than uploading three vertices for each triangle.
    bool is_local() const { return vertex_count <= indices.size(); }
};

/// What is drawn at once: one material's triangles.
struct Draw {
    std::span<const Vertex> vertices;
    std::span<const std::uint32_t> indices;  ///< three per triangle; they count from vertices[0]
    std::uint32_t material = 0;
    std::span<const VertexAttributes> attributes{};  ///< one per vertex, or none: white, and no tangents
};

/// Throws Error(usage) for a material that is not less than `material_count`, and a number of indices that is no
/// multiple of 3: what all draws are checked for.
void check_triangles(std::uint32_t material, std::size_t material_count, std::uint64_t index_count);

/// Throws Error(usage) for a material that is not less than `material_count`, a number of indices that is no multiple
/// of 3, and attributes that are not as many as the vertices. Indices themselves are looked at by take_batch.
void check_draw(const Draw& draw, std::size_t material_count);

/// The batch that begins with `indices` (not empty, a multiple of 3). Throws Error(usage) for an index that is not less
/// than `vertex_count`.
TriangleBatch take_batch(std::span<const std::uint32_t> indices, std::uint64_t vertex_count);

/// Writes indices that count from first_vertex.
void write_local_indices(const TriangleBatch& batch, std::uint32_t* destination);

/// Writes three vertices for each triangle, or what belongs to three vertices.
template <typename Element>
void write_corners(const TriangleBatch& batch, std::span<const Element> of_vertices, Element* destination) {
    std::transform(batch.indices.begin(), batch.indices.end(), destination,
                   [&](std::uint32_t index) { return of_vertices[index]; });
}

}  // namespace tessera::render
