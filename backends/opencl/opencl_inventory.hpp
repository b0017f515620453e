// Finds the OpenCL devices of a machine.
#pragma once

#include "backends/inventory.hpp"
#include "backends/opencl/opencl_device.hpp"

namespace tessera::backends::opencl {

/// A device that can be opened.
struct FoundDevice {
    cl_platform_id platform = nullptr;
    cl_device_id device = nullptr;
    DeviceFacts facts;
    gpu::DeviceInfo info;
};

struct Findings {
    const Api* api = nullptr;  ///< null where the loader is missing
    std::vector<FoundDevice> devices;
    std::vector<gpu::UnusableDevice> unusable;
};

/// Looks at every platform of the loader called `library`. Never throws for what is missing: `unusable` says it.
/// A device that is refused has the id "opencl", since no number opens it.
Findings find_devices(const std::string& library = default_library);

/// The part of `findings` that the registry shows.
Inventory inventory(const Findings& findings);

}  // namespace tessera::backends::opencl
