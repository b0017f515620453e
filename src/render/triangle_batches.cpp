#include "render/triangle_batches.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace tessera::render {

void check_triangles(std::uint32_t material, std::size_t material_count, std::uint64_t index_count) {
    if (material >= material_count) {
        throw Error(ErrorKind::usage,
                    fmt::format("A draw names material {}, but there are {}.", material, material_count));
    }
    if (index_count % 3 != 0) {
        throw Error(ErrorKind::usage, fmt::format("A draw has {} indices, which is no multiple of 3.", index_count));
    }
}

void check_draw(const Draw& draw, std::size_t material_count) {
    check_triangles(draw.material, material_count, draw.indices.size());
    if (!draw.attributes.empty() && draw.attributes.size() != draw.vertices.size()) {
        throw Error(ErrorKind::usage,
                    fmt::format("A draw has attributes of {} vertices for {} vertices; give none, or one per vertex.",
                                draw.attributes.size(), draw.vertices.size()));
    }
}

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

}  // namespace tessera::render
