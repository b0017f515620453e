// A rasteriser for every device: kernels alone (kernels/raster), so that a machine without Vulkan draws, and all
// devices draw the same picture to the bit.
//
// Edges are exact: vertices lie on a grid of 256 sub-pixels, edge functions are integers, the top-left rule gives every
// sample of a shared edge to one triangle. Depth ties go to what was drawn first. Materials are those of the Vulkan
// rasteriser: back faces culled unless double-sided, base colour, colours of vertices and texture (trilinear,
// repeating), alpha mask, and blending in the order of draws. A triangle is shaded once per pixel, at the point of it
// that is nearest to the pixel's middle.
//
// Memory is bounded whatever is drawn: 8 bytes per sample (2.1 GiB for 8192 x 8192 pixels of 4 samples), the textures,
// and about 200 MiB. The picture is drawn in windows of 2048 x 2048 pixels.
#pragma once

#include "gpu/device.hpp"
#include "render/rasteriser.hpp"

#include <memory>

namespace tessera::raster {

/// Draws on any device; frames have 1 or 4 samples per pixel. All other calls as in render::Rasteriser.
std::unique_ptr<render::Rasteriser> open_portable(const gpu::Device& device);

}  // namespace tessera::raster
