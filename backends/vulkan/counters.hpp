// What a backend has made so far: tests show with it that repeated work makes nothing new.
#pragma once

#include <cstdint>

#include "gpu/backend.hpp"

namespace tessera::backends::vulkan {

struct Counters {
    std::uint64_t allocations = 0;  ///< of device memory
    std::uint64_t pipelines = 0;
    std::uint64_t descriptor_sets = 0;
    std::uint64_t descriptor_pools = 0;
    std::uint64_t submissions = 0;
    std::uint64_t barriers = 0;  ///< between commands; the one to the host that ends a submission is not counted
    std::uint64_t kept = 0;      ///< objects destroyed by the user that the device still works with
};

/// Of a backend made by vulkan::open(); std::bad_cast for any other.
Counters counters(const gpu::Backend& backend);

}  // namespace tessera::backends::vulkan
