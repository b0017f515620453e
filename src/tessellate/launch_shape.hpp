// How emission maps to work items: 2^n items share a patch. The results do not depend on it.
#pragma once

#include "gpu/types.hpp"

#include <cstdint>

namespace tessera {

/// log2 of the items per patch for `patch_count` patches of `elements` elements in all. CPUs run an item as a scalar
/// loop, so they get one per patch unless that leaves cores idle; GPUs want neighbouring items to write neighbouring
/// elements.
inline std::uint32_t lanes_log2(const gpu::DeviceInfo& device, std::uint64_t patch_count, std::uint64_t elements) {
    const std::uint64_t average = patch_count == 0 ? 0 : elements / patch_count;
    std::uint64_t wanted = 1;
    if (device.software) {
        const std::uint64_t enough = 256ull * (device.compute_units == 0 ? 1 : device.compute_units);
        wanted = patch_count == 0 ? 1 : enough / patch_count;
    } else {
        wanted = average / 4;
    }
    std::uint32_t log2 = 0;
    while (log2 < 6 && (2ull << log2) <= wanted && (2ull << log2) <= average) {
        ++log2;
    }
    return log2;
}

}  // namespace tessera
