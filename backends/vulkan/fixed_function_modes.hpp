// Spacing and vertex order of an evaluation shader. GLSL has them as layout words of the source; in SPIR-V each is one
// word of the module, so that one compiled shader per domain serves all spacings and orders.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tessellate/options.hpp"

namespace tessera::backends::vulkan {

/// The module with another spacing and order. `clockwise` is the word of Vulkan. The partitioning is one of integer,
/// fractional_odd, fractional_even.
std::vector<std::uint32_t> with_modes(std::span<const std::uint32_t> spirv, Partitioning partitioning, bool clockwise);

}  // namespace tessera::backends::vulkan
