#include "render/mesh_sinks.hpp"

#include <algorithm>

namespace tessera::render {
namespace {

/// What a batch has of a part: vertices and indices, counted in the whole output. The vertices of a part lie together,
/// and batches are closed, so that each share can be drawn alone.
struct Share {
    std::uint64_t first_vertex = 0, vertex_count = 0;
    std::uint64_t first_index = 0, index_count = 0;
};

/// `batch` has the names of MeshPart. A share without indices is empty.
template <typename Batch>
Share share_of(const Batch& batch, std::uint64_t vertex_count, std::uint64_t index_count, const MeshPart& part) {
    const auto overlap = [](std::uint64_t first_a, std::uint64_t count_a, std::uint64_t first_b, std::uint64_t count_b,
                            std::uint64_t& first, std::uint64_t& count) {
        first = std::max(first_a, first_b);
        const std::uint64_t end = std::min(first_a + count_a, first_b + count_b);
        count = end > first ? end - first : 0;
    };
    Share share;
    overlap(part.first_vertex, part.vertex_count, batch.first_vertex, vertex_count, share.first_vertex,
            share.vertex_count);
    overlap(part.first_index, part.index_count, batch.first_index, index_count, share.first_index, share.index_count);
    return share;
}

}  // namespace

void DrawSink::append(const MeshBatch& batch) {
    for (const MeshPart& part : parts_) {
        const Share share = share_of(batch, batch.vertices.size(), batch.indices.size(), part);
        if (share.index_count == 0) continue;
        const auto indices = batch.indices.subspan(share.first_index - batch.first_index, share.index_count);
        local_.resize(indices.size());
        std::ranges::transform(
            indices, local_.begin(),
            [first = static_cast<std::uint32_t>(share.first_vertex)](std::uint32_t index) { return index - first; });
        const auto of_part = [&](auto all) {
            return all.empty() ? all : all.subspan(share.first_vertex - batch.first_vertex, share.vertex_count);
        };
        rasteriser_.draw(Draw{of_part(batch.vertices), local_, part.material, of_part(batch.attributes)});
    }
}

bool DrawSink::take_from_device(const DeviceMeshBatch& batch) {
    if (!rasteriser_.draws_from(batch.device)) return false;
    std::vector<DeviceDraw> draws;
    for (const MeshPart& part : parts_) {
        const Share share = share_of(batch, batch.vertex_count, batch.index_count, part);
        if (share.index_count == 0) continue;
        DeviceDraw draw;
        draw.vertices = batch.vertices;
        draw.indices = batch.indices;
        draw.attributes = batch.attributes;
        draw.first_vertex = share.first_vertex - batch.first_vertex;
        draw.vertex_count = share.vertex_count;
        draw.first_index = share.first_index - batch.first_index;
        draw.index_count = share.index_count;
        draw.index_base = static_cast<std::uint32_t>(share.first_vertex);
        draw.material = part.material;
        draws.push_back(std::move(draw));
    }
    rasteriser_.draw(draws);
    return true;
}

}  // namespace tessera::render
