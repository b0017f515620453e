// Triangles as they lie in buffers of a device: a tessellator's output, drawn without a detour by the host.
#pragma once

#include "gpu/device.hpp"

#include <cstdint>

namespace tessera::render {

/// What is drawn at once from device memory: one material's triangles. Buffers have the usage storage and are not
/// written while the picture is drawn.
struct DeviceDraw {
    gpu::Buffer vertices;                              ///< of Vertex
    gpu::Buffer indices;                               ///< of uint32, three per triangle
    gpu::Buffer attributes;                            ///< null, or VertexAttributes beside each vertex of `vertices`
    std::uint64_t first_vertex = 0, vertex_count = 0;  ///< the draw's vertices in the buffers
    std::uint64_t first_index = 0, index_count = 0;    ///< the draw's triangles in `indices`
    /// The index that names first_vertex. Triangles with others than the draw's vertices are dropped by the portable
    /// rasteriser; a device's own does with them what its API does.
    std::uint32_t index_base = 0;
    std::uint32_t material = 0;
};

/// Throws Error(usage) for a material that is not less than `material_count`, a number of indices that is no multiple
/// of 3, null or too small buffers, and ranges beyond 2^31 words.
void check_draw(const DeviceDraw& draw, std::size_t material_count);

}  // namespace tessera::render
