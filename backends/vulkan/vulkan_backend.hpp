// The Vulkan backend as the registry sees it. The loader is opened at run time; nothing here throws for a missing one.
#pragma once

#include "backends/inventory.hpp"
#include "gpu/backend.hpp"

namespace tessera::backends::vulkan {

/// Every Vulkan device of this machine; ids are "vulkan:0", "vulkan:1", ... Devices that cannot be used come with all
/// the reasons; so does a missing loader, driver or validation layer.
Inventory list();

/// How buffers are filled and read.
enum class HostAccess {
    automatic,  ///< directly where the device shares memory with the host, else through staging
    staged,     ///< always through staging, as on a device with memory of its own; for tests
};

/// Opens device `index` of list(). Throws Error(device_unavailable).
std::unique_ptr<gpu::Backend> open(std::size_t index, HostAccess access = HostAccess::automatic);

}  // namespace tessera::backends::vulkan
