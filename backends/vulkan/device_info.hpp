// What a physical device is, in the words of the device room.
#pragma once

#include "backends/vulkan/suitability.hpp"
#include "gpu/types.hpp"

namespace tessera::backends::vulkan {

/// Describes device `index` of candidates(). Everything is what the driver reports; nothing is guessed.
gpu::DeviceInfo describe(const vk::raii::PhysicalDevice& physical, std::size_t index);

/// True where the device offers `extension`.
bool offers(const vk::raii::PhysicalDevice& physical, std::string_view extension);

}  // namespace tessera::backends::vulkan
