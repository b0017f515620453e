// The shaders of the fixed-function oracle, compiled from shaders/ by the build.
#pragma once

#include <cstdint>
#include <span>

#include "tessellate/options.hpp"

namespace tessera::backends::vulkan::shaders {

std::span<const std::uint32_t> oracle_vertex();
std::span<const std::uint32_t> oracle_control(bool surface);
/// Equal spacing, clockwise; see with_modes(). Surfaces are over triangles only.
std::span<const std::uint32_t> oracle_evaluation(Domain domain, bool surface);

}  // namespace tessera::backends::vulkan::shaders
