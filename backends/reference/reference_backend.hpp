// The reference backend as the registry sees it: kernels as plain C++ on the processor. It is always there, and every
// other backend is compared with it.
#pragma once

#include "backends/inventory.hpp"
#include "gpu/backend.hpp"

namespace tessera::backends::reference {

/// The one reference device, "reference".
Inventory list();

/// Opens device `index` of list(). Throws Error(device_unavailable).
std::unique_ptr<gpu::Backend> open(std::size_t index);

}  // namespace tessera::backends::reference
