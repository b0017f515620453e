#include "backends/vulkan/errors.hpp"

namespace tessera::backends::vulkan {
namespace {

const char* advice(vk::Result result) {
    switch (result) {
        case vk::Result::eErrorOutOfDeviceMemory:
            return "the device is out of memory; lower the factor or --memory-budget, or choose another device";
        case vk::Result::eErrorOutOfHostMemory:
            return "the host is out of memory; lower the factor or --memory-budget";
        case vk::Result::eErrorTooManyObjects:
            return "the driver allows no more objects of this kind";
        case vk::Result::eErrorDeviceLost:
            return "the device was lost, often because a kernel ran too long; open it again or choose another device";
        case vk::Result::eErrorIncompatibleDriver:
            return "no installed driver can be used";
        default:
            return "choose another device with --device";
    }
}

}  // namespace

Error translate(const vk::SystemError& failure, std::string_view doing) {
    const auto result = static_cast<vk::Result>(failure.code().value());
    return Error(ErrorKind::device_unavailable,
                 fmt::format("Vulkan failed with {} while {}: {}.", vk::to_string(result), doing, advice(result)));
}

}  // namespace tessera::backends::vulkan
