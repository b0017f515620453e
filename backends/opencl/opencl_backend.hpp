// The OpenCL backend as the registry sees it. The loader is opened at run time; nothing here throws for a missing one.
#pragma once

#include "backends/inventory.hpp"
#include "gpu/backend.hpp"

namespace tessera::backends::opencl {

/// Every OpenCL device of this machine; ids are "opencl:0", "opencl:1", ...
Inventory list();

/// Opens device `index` of list(). Throws Error(device_unavailable).
std::unique_ptr<gpu::Backend> open(std::size_t index);

}  // namespace tessera::backends::opencl
