// What others that draw on a backend's device need of it: one queue, one order of submissions.
#pragma once

#include "backends/vulkan/objects.hpp"
#include "gpu/device.hpp"

namespace tessera::backends::vulkan {

struct Shared {
    const Context& context;
    Timeline& timeline;
};

/// Of a device that open() made; valid as long as the device.
Shared share(const gpu::Device& device);

/// A buffer of such a device.
inline Buffer& shared_buffer(const gpu::Buffer& buffer) {
    return static_cast<Buffer&>(buffer.object());
}

}  // namespace tessera::backends::vulkan
