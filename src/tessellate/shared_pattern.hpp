// The domain pattern that all patches of a job have in common where one set of factors holds for all: made once, then
// read by every patch instead of being worked out again.
#pragma once

#include "gpu/device.hpp"
#include "tessellate/options.hpp"
#include "tessellate/plan.hpp"

#include <cstdint>

namespace tessera {

/// Lies on one device. Without buffers and with stride 0 where patches differ, or where they are so few that making it
/// costs more.
struct SharedPattern {
    gpu::Buffer points;        ///< u and v as kernels/layout.h says at PATTERN_MARGIN
    gpu::Buffer indices;       ///< of the pattern's points, from 0 on
    std::uint32_t stride = 0;  ///< as kernels/layout.h's EmitParams::pattern
    PatchOffset size{};        ///< vertices and indices of every patch

    std::uint64_t device_bytes() const { return points.size() + indices.size(); }
};

/// The pattern of `patch_count` patches of one domain; waits for the device.
SharedPattern make_shared_pattern(gpu::Device device, Domain domain, const TessellationOptions& options,
                                  std::uint64_t patch_count);

}  // namespace tessera
