// What an OpenCL device says of itself, whether it will do, and what the project calls it.
#pragma once

#include "backends/opencl/opencl_api.hpp"
#include "gpu/types.hpp"

#include <vector>

namespace tessera::backends::opencl {

/// Items of one work group; kernels are written for this size (WORKGROUP_SIZE of the kernel dialect).
inline constexpr std::size_t group_size = 64;

/// Answers of the driver, in the units of the OpenCL API unless said otherwise.
struct DeviceFacts {
    std::string name;
    std::string platform;
    std::string driver_version;
    std::string version;  ///< "OpenCL <major>.<minor> <vendor text>"
    cl_device_type type = 0;
    bool available = false;
    bool compiler = false;
    bool little_endian = false;
    cl_device_fp_config single_fp = 0;
    cl_command_queue_properties queue_properties = 0;
    std::size_t max_group_size = 0;
    std::size_t max_items_x = 0;
    cl_ulong max_allocation = 0;     ///< bytes
    cl_uint base_alignment = 0;      ///< bytes
    std::size_t max_parameters = 0;  ///< bytes of kernel arguments
    cl_uint address_bits = 0;
    cl_uint compute_units = 0;
};

/// Asks the driver. Throws Error(device_unavailable) where it does not answer.
DeviceFacts query_device(const Api& api, cl_platform_id platform, cl_device_id device);

/// Every reason why the device cannot run the project's kernels, each a clause ("it has no compiler"); empty if it can.
std::vector<std::string> refusals(const DeviceFacts& facts);

/// The device in the words of the device room. `id` is "opencl:N".
gpu::DeviceInfo describe(const DeviceFacts& facts, const std::string& id);

}  // namespace tessera::backends::opencl
