#include "tessellate/mesh_parts.hpp"

#include <algorithm>

namespace tessera {

void add_to_parts(MeshTotals& totals, std::span<const patches::PatchRange> ranges, std::uint64_t per_patch,
                  const Chunk& chunk, std::span<const PatchOffset> offsets) {
    const std::uint64_t chunk_end = chunk.first_patch + chunk.patch_count;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const std::uint64_t range_first = ranges[i].first_patch * per_patch;
        const std::uint64_t range_end = range_first + ranges[i].patch_count * per_patch;
        const std::uint64_t first = std::max(range_first, chunk.first_patch);
        const std::uint64_t end = std::min(range_end, chunk_end);
        if (first < end) {
            const PatchOffset& from = offsets[first - chunk.first_patch];
            const PatchOffset& to = offsets[end - chunk.first_patch];
            totals.parts[i].vertex_count += to.vertex - from.vertex;
            totals.parts[i].index_count += to.index - from.index;
        }
    }
}

void place_parts(MeshTotals& totals) {
    for (MeshPart& part : totals.parts) {
        part.first_vertex = totals.vertex_count;
        part.first_index = totals.index_count;
        totals.vertex_count += part.vertex_count;
        totals.index_count += part.index_count;
    }
}

void scale_to_model(std::span<Vertex> vertices, int exponent) {
    for (Vertex& vertex : vertices) {
        for (float& coordinate : vertex.position)
            coordinate = patches::to_model_space(coordinate, exponent);
    }
}

}  // namespace tessera
