#include "render/resident_mesh.hpp"

#include "base/error.hpp"

#include <fmt/format.h>

namespace tessera::render {
namespace {

gpu::Buffer put(gpu::Device device, const char* label, std::span<const std::byte> bytes) {
    const gpu::Buffer buffer =
        device.create_buffer({label, bytes.size(), gpu::BufferUsage::storage | gpu::BufferUsage::copy_destination});
    device.queue().write_buffer(buffer, 0, bytes);
    return buffer;
}

}  // namespace

DeviceDraw upload_mesh(const gpu::Device& device, std::span<const Vertex> vertices,
                       std::span<const std::uint32_t> indices, std::span<const VertexAttributes> attributes) {
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
    draw.vertices = put(device, "vertices", std::as_bytes(vertices));
    draw.indices = put(device, "indices", std::as_bytes(indices));
    if (!attributes.empty()) draw.attributes = put(device, "attributes", std::as_bytes(attributes));
    draw.vertex_count = vertices.size();
    draw.index_count = indices.size();
    return draw;
}

}  // namespace tessera::render
