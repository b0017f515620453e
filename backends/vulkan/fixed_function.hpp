// The fixed-function oracle on Vulkan: patches go through a real tessellation control and evaluation shader, and
// transform feedback captures what the tessellator between them made.
#pragma once

#include <cstddef>
#include <memory>

#include "verify/fixed_function.hpp"

namespace tessera::backends::vulkan {

/// Opens device `index` of list(). Throws Error(device_unavailable) where it is missing, or lacks tessellationShader or
/// VK_EXT_transform_feedback.
std::unique_ptr<verify::FixedFunctionTessellator> open_fixed_function(std::size_t index);

}  // namespace tessera::backends::vulkan
