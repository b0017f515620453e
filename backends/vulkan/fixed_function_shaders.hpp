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

/// Those of timed draws; the vertex stage is the oracle's.
std::span<const std::uint32_t> timed_control();
/// Equal spacing, clockwise; see with_modes().
std::span<const std::uint32_t> timed_evaluation();
std::span<const std::uint32_t> timed_fragment();

}  // namespace tessera::backends::vulkan::shaders
