// Shader modules from embedded SPIR-V.
#pragma once

#include "backends/vulkan/context.hpp"

#include <cstdint>
#include <span>

namespace tessera::backends::vulkan {

inline vk::raii::ShaderModule create_module(const Context& context, std::span<const std::uint32_t> spirv) {
    return {context.device, vk::ShaderModuleCreateInfo({}, spirv.size_bytes(), spirv.data())};
}

}  // namespace tessera::backends::vulkan
