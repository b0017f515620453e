#include "raster/draw_uploads.hpp"

#include "tessellate/stage.hpp"

#include <numeric>

namespace tessera::raster {
namespace {

constexpr std::uint64_t most_corners = 3 * render::TriangleBatch::max_triangles;

}  // namespace

DrawUploads::DrawUploads(const gpu::Device& device)
    : device_(device),
      vertices_(device_.create_buffer({"vertices to draw", most_corners * sizeof(Vertex), storage_usage})),
      attributes_(
          device_.create_buffer({"attributes to draw", most_corners * sizeof(VertexAttributes), storage_usage})),
      indices_(device_.create_buffer({"indices to draw", most_corners * 4, storage_usage})) {}

template <typename Element>
void DrawUploads::upload(const render::TriangleBatch& batch, std::span<const Element> of_vertices,
                         const gpu::Buffer& to) {
    if (batch.is_local()) {
        const auto used = of_vertices.subspan(batch.first_vertex, batch.vertex_count);
        device_.queue().write_buffer(to, 0, std::as_bytes(used));
        return;
    }
    corners_.resize(batch.indices.size() * sizeof(Element));
    render::write_corners(batch, of_vertices, reinterpret_cast<Element*>(corners_.data()));
    device_.queue().write_buffer(to, 0, corners_);
}

render::DeviceDraw DrawUploads::upload(const render::TriangleBatch& batch, const render::Draw& draw) {
    render::DeviceDraw uploaded;
    uploaded.vertices = vertices_;
    uploaded.indices = indices_;
    uploaded.index_count = batch.indices.size();
    uploaded.material = draw.material;
    std::span<const std::uint32_t> indices = batch.indices;
    if (batch.is_local()) {
        uploaded.vertex_count = batch.vertex_count;
        uploaded.index_base = batch.first_vertex;
    } else {
        uploaded.vertex_count = indices.size();
        numbers_.resize(indices.size());
        std::iota(numbers_.begin(), numbers_.end(), 0u);
        indices = numbers_;
    }
    upload(batch, draw.vertices, vertices_);
    if (!draw.attributes.empty()) {
        upload(batch, draw.attributes, attributes_);
        uploaded.attributes = attributes_;
    }
    device_.queue().write_buffer(indices_, 0, std::as_bytes(indices));
    return uploaded;
}

}  // namespace tessera::raster
