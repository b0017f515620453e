// The Vulkan rasteriser: 4 samples per pixel, depth, back faces culled unless the material is double-sided, base colour
// factor and texture, alpha mask and blend. It needs no optional feature of Vulkan 1.1.
//
// Memory is bounded whatever is drawn: 36 bytes per pixel, the textures, and 64 MiB through which vertices and indices
// pass, 131,072 triangles at a time. Blended triangles are drawn where they come in the order of draws, tested against
// depth without writing it: draw opaque materials first and blended ones from back to front. The wireframe shows every
// material opaque.
#pragma once

#include <memory>

#include "render/rasteriser.hpp"

namespace tessera::backends::vulkan {

/// Draws on a device that open() made, and keeps it alive. Draws come from its buffers too but for wireframes, and but
/// for devices whose indices have fewer than 32 bits.
std::unique_ptr<render::Rasteriser> open_rasteriser(const gpu::Device& device);

}  // namespace tessera::backends::vulkan
