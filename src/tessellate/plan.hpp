// How a job is cut: chunks of patches that are counted and scanned together, and batches of a chunk whose output fits
// one pair of buffers. Pure functions of numbers, so that every device of a comparison gets the same plan.
#pragma once

#include "gpu/types.hpp"
#include "tessellate/options.hpp"
#include "tessellate/refined_mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera {

/// Patches [first_patch, first_patch + patch_count).
struct Chunk {
    std::uint64_t first_patch = 0;
    std::uint32_t patch_count = 0;
};

/// Where a patch's output begins within its chunk; the last entry of a chunk's list holds the totals.
struct PatchOffset {
    std::uint32_t vertex = 0;
    std::uint32_t index = 0;
};
static_assert(sizeof(PatchOffset) == 8);

/// Patches of a chunk that are emitted together; positions count within the chunk.
struct Batch {
    std::uint32_t first_patch = 0;
    std::uint32_t patch_count = 0;
    std::uint32_t first_vertex = 0, vertex_count = 0;
    std::uint32_t first_index = 0, index_count = 0;
};

/// Sizes that hold for a whole job.
struct JobPlan {
    std::vector<Chunk> chunks;
    std::uint32_t largest_chunk = 0;        ///< patches
    std::uint64_t vertex_buffer_bytes = 0;  ///< at most, for one batch; tangents and attributes take as much each
    std::uint64_t index_buffer_bytes = 0;   ///< likewise
};

/// Floats from one control net of a job to the next: what a quad needs where the job has quads, else a triangle.
std::uint32_t net_stride(const TessellationOptions& options, bool has_quads);

/// Cuts `patch_count` patches into chunks so that chunk buffers take about a third of the memory budget, fit a binding
/// and have 32-bit offsets. `shared_bytes` is what the job holds besides (control vertices), `attribute_bytes` what it
/// holds per patch for attributes of corners, 0 where there are none. Throws Error(usage)
/// where the budget cannot hold a single patch, with the least budget that can.
JobPlan plan_job(std::uint64_t patch_count, bool has_quads, std::uint64_t shared_bytes,
                 const TessellationOptions& options, const gpu::Limits& limits, std::uint64_t attribute_bytes = 0);

/// Cuts a chunk into batches that fit the plan's buffers. `offsets` has one entry per patch and one for the totals.
/// Patches without output make no batch of their own.
std::vector<Batch> plan_batches(std::span<const PatchOffset> offsets, const JobPlan& plan);

}  // namespace tessera
