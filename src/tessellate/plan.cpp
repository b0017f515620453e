#include "tessellate/plan.hpp"

#include "base/error.hpp"
#include "layout.h"

#include <fmt/format.h>
#include <algorithm>

namespace tessera {
namespace {

// The largest patch of any domain: a quad at factor 64.
constexpr std::uint64_t largest_patch_vertices = 4225;
constexpr std::uint64_t largest_patch_indices = 3 * 8192;

// Bytes per patch held while a chunk is worked on: patch indices, list entry, factors, record, counts, offsets, net,
// corner tags where the scheme has any. The scan's upper levels add less than a hundredth.
std::uint64_t chunk_bytes_per_patch(const TessellationOptions& options, std::uint64_t net_bytes) {
    const std::uint64_t tags = options.scheme == Scheme::stpn ? PATCH_CORNERS * CORNER_TAG_FLOATS : 0;
    return (PATCH_CORNERS + 1 + PATCH_FACTORS + RECORD_WORDS + 2 * COUNT_WORDS + tags) * 4 + 1 + net_bytes;
}

}  // namespace

std::uint32_t net_stride(const TessellationOptions& options, bool has_quads) {
    const std::uint32_t points_degree = degree(options.scheme);
    const std::uint32_t normal_degree = options.normals == Normals::quadratic ? 2u : 1u;
    return has_quads ? QUAD_NET_FLOATS(points_degree, normal_degree) : NET_FLOATS(points_degree, normal_degree);
}

JobPlan plan_job(std::uint64_t patch_count, bool has_quads, std::uint64_t shared_bytes,
                 const TessellationOptions& options, const gpu::Limits& limits, std::uint64_t attribute_bytes) {
    const std::uint64_t net_bytes = std::uint64_t{net_stride(options, has_quads)} * 4;
    const std::uint64_t per_patch = chunk_bytes_per_patch(options, net_bytes) + attribute_bytes;
    constexpr std::uint64_t small_buffers = 64 << 10;  // kernel parameters, query results
    constexpr std::uint64_t patch_vertex_bytes = largest_patch_vertices * sizeof(Vertex);
    constexpr std::uint64_t patch_index_bytes = largest_patch_indices * 4;
    // Vertices, and tangents and attributes of the same size.
    const std::uint64_t vertex_buffers =
        1 + (options.tangents == Tangents::none ? 0 : 1) + (attribute_bytes == 0 ? 0 : 1);
    const std::uint64_t least_output = vertex_buffers * patch_vertex_bytes + patch_index_bytes;
    const std::uint64_t least = shared_bytes + small_buffers + per_patch + least_output;
    if (options.memory_budget < least) {
        throw Error(ErrorKind::usage,
                    fmt::format("The memory budget of {} bytes is too small for this model; it needs at least {}.",
                                options.memory_budget, least));
    }
    const std::uint64_t binding = std::min(limits.max_storage_binding_size, limits.max_buffer_size);
    const std::uint64_t free_bytes = options.memory_budget - shared_bytes - small_buffers;
    const std::uint64_t by_budget =
        std::max<std::uint64_t>(1, std::min(free_bytes / 3, free_bytes - least_output) / per_patch);
    const std::uint64_t by_binding = binding / std::max(net_bytes, attribute_bytes);
    const std::uint64_t by_offsets = 0xffffffffull / largest_patch_indices;
    const std::uint64_t chunk = std::min({by_budget, by_binding, by_offsets, patch_count});

    JobPlan plan;
    for (std::uint64_t first = 0; first < patch_count; first += chunk) {
        plan.chunks.push_back({first, static_cast<std::uint32_t>(std::min(chunk, patch_count - first))});
    }
    plan.largest_chunk = static_cast<std::uint32_t>(chunk);
    // A patch has about as many bytes of vertices as of indices in the limit, so each buffer gets the same, but never
    // less than the largest patch needs.
    const std::uint64_t output = free_bytes - chunk * per_patch;
    const std::uint64_t vertex_share =
        std::clamp(output / (vertex_buffers + 1), patch_vertex_bytes, (output - patch_index_bytes) / vertex_buffers);
    plan.vertex_buffer_bytes = std::min(binding, vertex_share) / sizeof(Vertex) * sizeof(Vertex);
    plan.index_buffer_bytes = std::min(binding, output - vertex_buffers * plan.vertex_buffer_bytes) / 12 * 12;
    return plan;
}

std::vector<Batch> plan_batches(std::span<const PatchOffset> offsets, const JobPlan& plan) {
    const std::uint64_t most_vertices = plan.vertex_buffer_bytes / sizeof(Vertex);
    const std::uint64_t most_indices = plan.index_buffer_bytes / 4;
    std::vector<Batch> batches;
    const std::size_t patch_count = offsets.empty() ? 0 : offsets.size() - 1;
    for (std::size_t first = 0; first < patch_count;) {
        // The last patch whose end still fits: offsets never decrease, so both conditions are monotone.
        const auto fits = [&](const PatchOffset& end) {
            return end.vertex - offsets[first].vertex <= most_vertices &&
                   end.index - offsets[first].index <= most_indices;
        };
        const auto begin = offsets.begin() + static_cast<std::ptrdiff_t>(first) + 1;
        const auto end = std::partition_point(begin, offsets.end(), fits);
        if (end == begin) {
            throw Error(ErrorKind::usage,
                        fmt::format("A patch of {} vertices does not fit the output buffer of {} bytes.",
                                    begin->vertex - offsets[first].vertex, plan.vertex_buffer_bytes));
        }
        const auto next = static_cast<std::size_t>(end - offsets.begin()) - 1;
        const PatchOffset& from = offsets[first];
        const PatchOffset& to = offsets[next];
        if (to.vertex > from.vertex) {
            batches.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(next - first), from.vertex,
                               to.vertex - from.vertex, from.index, to.index - from.index});
        }
        first = next;
    }
    return batches;
}

}  // namespace tessera
