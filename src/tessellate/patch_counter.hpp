// Factors -> records -> counts -> offsets: the part of the pipeline that knows nothing of surfaces.
#pragma once

#include "tessellate/options.hpp"
#include "tessellate/plan.hpp"
#include "tessellate/stage.hpp"

namespace tessera {

/// Holds the buffers of up to `capacity` patches on one device and runs the counting stages over them.
class PatchCounter {
public:
    /// `patch_corners` (four words per patch) tells the domain of each; without it, all have the one that
    /// record_factors() is given.
    PatchCounter(gpu::Device& device, std::uint32_t capacity, bool factors_per_patch, ParameterRing& parameters,
                 const gpu::Buffer& patch_corners = {});

    /// Uploads factors: one set, or one per patch of the chunk, as `factors_per_patch` said.
    void upload_factors(gpu::Device& device, std::span<const PatchFactors> factors);
    /// Records stage 1, factors -> records. `domain` counts where there are no patch corners.
    void record_factors(gpu::ComputePass& pass, std::uint32_t patch_count, Domain domain, Partitioning partitioning,
                        bool flip);
    /// Records stage 3, counts.
    void record_counts(gpu::ComputePass& pass, std::uint32_t patch_count);
    /// Records stage 4, the exclusive scan.
    void record_scan(gpu::ComputePass& pass, std::uint32_t patch_count);
    /// Waits, and reads patch_count + 1 offsets: one per patch and the totals.
    std::vector<PatchOffset> read_offsets(gpu::Device& device, std::uint32_t patch_count) const;

    /// Device memory held, in bytes.
    std::uint64_t device_bytes() const;

    const gpu::Buffer& records() const { return records_; }
    const gpu::Buffer& counts() const { return levels_.front().values; }
    const gpu::Buffer& offsets() const { return levels_.front().offsets; }

    /// Parameter slots that one round of counting takes at most.
    static constexpr std::uint32_t parameter_slots = 12;

private:
    // One level of the scan: its values, their exclusive prefix sums, and the stages to and from the level above.
    struct Level {
        std::uint64_t capacity = 0;
        gpu::Buffer values, offsets;
        Stage sums, spread;
    };

    ParameterRing& parameters_;
    bool factors_per_patch_;
    bool domain_per_patch_;
    gpu::Buffer factors_, records_, zero_;
    Stage factors_stage_, counts_stage_;
    std::vector<Level> levels_;
};

}  // namespace tessera
