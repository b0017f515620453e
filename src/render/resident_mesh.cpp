#include "render/resident_mesh.hpp"

#include "base/error.hpp"

#include <fmt/format.h>

namespace tessera::render {
DeviceDraw upload_mesh(gpu::Device device, std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
                       std::span<const VertexAttributes> attributes) {
    if (vertices.empty() || indices.empty()) {
        throw Error(ErrorKind::usage, fmt::format("A mesh of {} vertices and {} indices has nothing to upload.",
                                                  vertices.size(), indices.size()));
    }
    if (!attributes.empty() && attributes.size() != vertices.size()) {
        throw Error(ErrorKind::usage,
                    fmt::format("A mesh has attributes of {} vertices for {} vertices; give none, or one per vertex.",
                                attributes.size(), vertices.size()));
    }
    DeviceDraw draw;
    draw.vertices = gpu::create_filled_buffer(device, "vertices", std::as_bytes(vertices));
    draw.indices = gpu::create_filled_buffer(device, "indices", std::as_bytes(indices));
    if (!attributes.empty())
        draw.attributes = gpu::create_filled_buffer(device, "attributes", std::as_bytes(attributes));
    draw.vertex_count = vertices.size();
    draw.index_count = indices.size();
    return draw;
}

}  // namespace tessera::render
