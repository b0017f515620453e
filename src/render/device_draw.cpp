#include "render/device_draw.hpp"

#include "base/error.hpp"
#include "base/vertex.hpp"
#include "base/vertex_attributes.hpp"
#include "render/rasteriser.hpp"

#include <fmt/format.h>
#include <algorithm>

namespace tessera::render {
namespace {

constexpr std::uint64_t addressable_words = std::uint64_t{1} << 31;  // by signed numbers

void check_range(const char* what, const gpu::Buffer& buffer, std::uint64_t first, std::uint64_t count,
                 std::uint64_t element_bytes) {
    if (!buffer) {
        throw Error(ErrorKind::usage, fmt::format("A draw from device memory has no buffer of {}.", what));
    }
    const std::uint64_t room = std::min(buffer.size(), addressable_words * 4) / element_bytes;
    if (first > room || count > room - first) {
        throw Error(ErrorKind::usage, fmt::format("A draw takes {} {} from number {} of buffer \"{}\", which holds {}.",
                                                  count, what, first, buffer.label(), room));
    }
}

}  // namespace

void check_draw(const DeviceDraw& draw, std::size_t material_count) {
    check_triangles(draw.material, material_count, draw.index_count);
    check_range("vertices", draw.vertices, draw.first_vertex, draw.vertex_count, sizeof(Vertex));
    check_range("indices", draw.indices, draw.first_index, draw.index_count, sizeof(std::uint32_t));
    if (draw.attributes) {
        check_range("attributes", draw.attributes, draw.first_vertex, draw.vertex_count, sizeof(VertexAttributes));
    }
}

void Rasteriser::draw(std::span<const DeviceDraw> /*draws*/) {
    throw Error(ErrorKind::usage, "This rasteriser draws from host memory alone; read the mesh back first.");
}

}  // namespace tessera::render
