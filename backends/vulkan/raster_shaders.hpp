// The shaders of the rasteriser, compiled from shaders/ by the build.
#pragma once

#include <cstdint>
#include <span>

namespace tessera::backends::vulkan::shaders {

std::span<const std::uint32_t> mesh_vertex();
std::span<const std::uint32_t> mesh_fragment();
std::span<const std::uint32_t> resolve_vertex();
std::span<const std::uint32_t> resolve_fragment();

}  // namespace tessera::backends::vulkan::shaders
