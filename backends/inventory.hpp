// What a machine has: usable devices, and what is missing with its reason.
#pragma once

#include "gpu/types.hpp"

#include <vector>

namespace tessera::backends {

struct Inventory {
    std::vector<gpu::DeviceInfo> devices;
    std::vector<gpu::UnusableDevice> unusable;
};

}  // namespace tessera::backends
