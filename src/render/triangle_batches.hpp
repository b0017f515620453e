// Cuts a mesh of any size into pieces of bounded size.
#pragma once

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

/// The batch that begins with `indices` (not empty, a multiple of 3). Throws Error(usage) for an index that is not less
/// than `vertex_count`.
TriangleBatch take_batch(std::span<const std::uint32_t> indices, std::uint64_t vertex_count);

/// Writes indices that count from first_vertex.
void write_local_indices(const TriangleBatch& batch, std::uint32_t* destination);

/// Writes three vertices for each triangle.
void write_corners(const TriangleBatch& batch, std::span<const Vertex> vertices, Vertex* destination);

}  // namespace tessera::render
