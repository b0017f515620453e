#include "backends/opencl/opencl_device.hpp"

#include "kernels/dialect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <limits>

namespace tessera::backends::opencl {

static_assert(group_size == WORKGROUP_SIZE);

namespace {

template <typename T>
T device_value(const Api& api, cl_device_id device, cl_device_info what) {
    T value{};
    check(api.clGetDeviceInfo(device, what, sizeof value, &value, nullptr),
          fmt::format("query device info {:#x}", what));
    return value;
}

// `ask` is called as clGetDeviceInfo without its first two arguments.
template <typename Ask>
std::string text(Ask ask, const char* what) {
    std::size_t size = 0;
    check(ask(0, nullptr, &size), fmt::format("query the {}", what));
    std::string value(size, '\0');
    check(ask(size, value.data(), nullptr), fmt::format("query the {}", what));
    value.resize(std::min(value.find('\0'), value.size()));
    const std::size_t first = value.find_first_not_of(' ');
    return first == std::string::npos ? std::string() : value.substr(first, value.find_last_not_of(' ') - first + 1);
}

std::string device_text(const Api& api, cl_device_id device, cl_device_info info, const char* what) {
    return text([&](auto... rest) { return api.clGetDeviceInfo(device, info, rest...); }, what);
}

bool at_least_1_2(const std::string& version) {
    int major = 0, minor = 0;
    return std::sscanf(version.c_str(), "OpenCL %d.%d", &major, &minor) == 2 &&
           (major > 1 || (major == 1 && minor >= 2));
}

}  // namespace

DeviceFacts query_device(const Api& api, cl_platform_id platform, cl_device_id device) {
    DeviceFacts facts;
    facts.name = device_text(api, device, CL_DEVICE_NAME, "device name");
    facts.platform =
        text([&](auto... rest) { return api.clGetPlatformInfo(platform, CL_PLATFORM_NAME, rest...); }, "platform name");
    facts.driver_version = device_text(api, device, CL_DRIVER_VERSION, "driver version");
    facts.version = device_text(api, device, CL_DEVICE_VERSION, "device version");
    facts.type = device_value<cl_device_type>(api, device, CL_DEVICE_TYPE);
    facts.available = device_value<cl_bool>(api, device, CL_DEVICE_AVAILABLE) != CL_FALSE;
    facts.compiler = device_value<cl_bool>(api, device, CL_DEVICE_COMPILER_AVAILABLE) != CL_FALSE;
    facts.little_endian = device_value<cl_bool>(api, device, CL_DEVICE_ENDIAN_LITTLE) != CL_FALSE;
    facts.single_fp = device_value<cl_device_fp_config>(api, device, CL_DEVICE_SINGLE_FP_CONFIG);
    facts.queue_properties = device_value<cl_command_queue_properties>(api, device, CL_DEVICE_QUEUE_PROPERTIES);
    facts.max_group_size = device_value<std::size_t>(api, device, CL_DEVICE_MAX_WORK_GROUP_SIZE);
    const auto dimensions = device_value<cl_uint>(api, device, CL_DEVICE_MAX_WORK_ITEM_DIMENSIONS);
    std::vector<std::size_t> items(std::max<cl_uint>(dimensions, 1));
    check(api.clGetDeviceInfo(device, CL_DEVICE_MAX_WORK_ITEM_SIZES, items.size() * sizeof items[0], items.data(),
                              nullptr),
          "query the work item sizes");
    facts.max_items_x = items[0];
    facts.max_allocation = device_value<cl_ulong>(api, device, CL_DEVICE_MAX_MEM_ALLOC_SIZE);
    facts.base_alignment = device_value<cl_uint>(api, device, CL_DEVICE_MEM_BASE_ADDR_ALIGN) / 8;
    facts.max_parameters = device_value<std::size_t>(api, device, CL_DEVICE_MAX_PARAMETER_SIZE);
    facts.address_bits = device_value<cl_uint>(api, device, CL_DEVICE_ADDRESS_BITS);
    facts.compute_units = device_value<cl_uint>(api, device, CL_DEVICE_MAX_COMPUTE_UNITS);
    return facts;
}

std::vector<std::string> refusals(const DeviceFacts& facts) {
    const gpu::Limits needed;
    std::vector<std::string> reasons;
    const auto refuse_unless = [&](bool fine, std::string reason) {
        if (!fine) {
            reasons.push_back(std::move(reason));
        }
    };
    refuse_unless(at_least_1_2(facts.version),
                  fmt::format("it offers \"{}\" where OpenCL 1.2 is needed", facts.version));
    refuse_unless(facts.available, "its driver says that it is not available");
    refuse_unless(facts.compiler, "it has no compiler for OpenCL C");
    refuse_unless(facts.little_endian, "it is big-endian");
    refuse_unless((facts.single_fp & CL_FP_ROUND_TO_NEAREST) != 0, "its 32-bit floats do not round to nearest");
    refuse_unless(std::min(facts.max_group_size, facts.max_items_x) >= group_size,
                  fmt::format("its work groups hold {} items where {} are needed",
                              std::min(facts.max_group_size, facts.max_items_x), group_size));
    refuse_unless(facts.max_allocation >= needed.max_storage_binding_size,
                  fmt::format("its buffers hold {} bytes where {} are needed", facts.max_allocation,
                              needed.max_storage_binding_size));
    refuse_unless(facts.max_parameters * 8 >= (needed.max_storage_buffers + 1ull) * facts.address_bits,
                  fmt::format("its kernels take {} bytes of arguments where {} are needed", facts.max_parameters,
                              (needed.max_storage_buffers + 1ull) * facts.address_bits / 8));
    return reasons;
}

gpu::DeviceInfo describe(const DeviceFacts& facts, const std::string& id) {
    gpu::DeviceInfo info;
    info.id = id;
    info.backend = "opencl";
    info.name = facts.name;
    info.driver = fmt::format("{} {}", facts.platform, facts.driver_version);
    info.version = facts.version;
    info.software = (facts.type & CL_DEVICE_TYPE_CPU) != 0;
    info.timestamps = (facts.queue_properties & CL_QUEUE_PROFILING_ENABLE) != 0;
    info.compute_units = facts.compute_units;

    // Kernels count bytes and items in 32 bits, so no more than 4 GiB of a buffer can be bound, whatever its size.
    // A uniform is a global pointer too, and one more argument; its limits stay those of WebGPU.
    constexpr std::uint64_t addressable = std::numeric_limits<std::uint32_t>::max() - 3ull;
    const std::uint64_t pointers = facts.max_parameters * 8 / facts.address_bits;
    info.limits.max_storage_buffers = static_cast<std::uint32_t>(std::min<std::uint64_t>(pointers - 1, 64));
    info.limits.max_buffer_size = facts.max_allocation & ~3ull;
    info.limits.max_storage_binding_size = std::min(info.limits.max_buffer_size, addressable);
    info.limits.max_workgroup_invocations =
        static_cast<std::uint32_t>(std::min<std::size_t>({facts.max_group_size, facts.max_items_x, 65536}));
    // Bound ranges are sub-buffers, which begin at multiples of the base alignment.
    const std::uint32_t alignment = std::max<std::uint32_t>(256, facts.base_alignment);
    info.limits.storage_offset_alignment = alignment;
    info.limits.uniform_offset_alignment = alignment;

    // Without CL_FP_DENORM a device may flush or not: OpenCL has no word for "always flushes".
    const bool denormals = (facts.single_fp & CL_FP_DENORM) != 0;
    info.float_controls.preserves_denormals = denormals;
    if (denormals) {
        info.float_controls.flushes_denormals = false;
    }
    info.float_controls.preserves_nan_and_infinity = (facts.single_fp & CL_FP_INF_NAN) != 0;
    info.float_controls.rounds_to_nearest_even = (facts.single_fp & CL_FP_ROUND_TO_NEAREST) != 0;
    return info;
}

}  // namespace tessera::backends::opencl
