#include "render/triangle_batches.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace tessera::render {

TriangleBatch take_batch(std::span<const std::uint32_t> indices, std::uint64_t vertex_count) {
    TriangleBatch batch;
    batch.indices = indices.first(std::min(indices.size(), TriangleBatch::max_triangles * 3));
    std::uint32_t smallest = UINT32_MAX;  // a loop that compilers vectorise, unlike std::minmax_element
    std::uint32_t largest = 0;
    for (const std::uint32_t index : batch.indices) {
        smallest = std::min(smallest, index);
        largest = std::max(largest, index);
    }
    if (largest >= vertex_count) {
        throw Error(ErrorKind::usage, fmt::format("A draw has index {}, but only {} vertices: indices count from the "
                                                  "first vertex of the draw.",
                                                  largest, vertex_count));
    }
    batch.first_vertex = smallest;
    batch.vertex_count = std::uint64_t{largest} - smallest + 1;
    return batch;
}

void write_local_indices(const TriangleBatch& batch, std::uint32_t* destination) {
    std::transform(batch.indices.begin(), batch.indices.end(), destination,
                   [&](std::uint32_t index) { return index - batch.first_vertex; });
}

void write_corners(const TriangleBatch& batch, std::span<const Vertex> vertices, Vertex* destination) {
    std::transform(batch.indices.begin(), batch.indices.end(), destination,
                   [&](std::uint32_t index) { return vertices[index]; });
}

}  // namespace tessera::render
