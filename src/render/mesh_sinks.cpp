#include "render/mesh_sinks.hpp"

#include <algorithm>

namespace tessera::render {

void DrawSink::append(const MeshBatch& batch) {
    const std::uint64_t batch_end = batch.first_index + batch.indices.size();
    for (const MeshPart& part : parts_) {
        const std::uint64_t first = std::max(part.first_index, batch.first_index);
        const std::uint64_t end = std::min(part.first_index + part.index_count, batch_end);
        if (first >= end) {
            continue;
        }
        // The vertices of a part lie together too, and batches are closed: draw them alone.
        const std::uint64_t vertex_end = batch.first_vertex + batch.vertices.size();
        const std::uint64_t first_vertex = std::max(part.first_vertex, batch.first_vertex);
        const std::uint64_t last_vertex = std::min(part.first_vertex + part.vertex_count, vertex_end);
        local_.assign(batch.indices.begin() + static_cast<std::ptrdiff_t>(first - batch.first_index),
                      batch.indices.begin() + static_cast<std::ptrdiff_t>(end - batch.first_index));
        for (std::uint32_t& index : local_) {
            index -= static_cast<std::uint32_t>(first_vertex);
        }
        const auto of_part = [&](auto all) {
            return all.empty() ? all : all.subspan(first_vertex - batch.first_vertex, last_vertex - first_vertex);
        };
        rasteriser_.draw(Draw{of_part(batch.vertices), local_, part.material, of_part(batch.attributes)});
    }
}

}  // namespace tessera::render
