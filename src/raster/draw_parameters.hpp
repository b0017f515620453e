// What the kernels of the rasteriser are told about picture and material.
#pragma once

#include "raster/raster_layout.h"
#include "raster/texel_buffers.hpp"
#include "render/rasteriser.hpp"

namespace tessera::raster {

/// The part of the parameters that all draws of a picture share. The camera's matrices are multiplied in double
/// precision, once.
kernels::DrawParams frame_parameters(const render::Frame& frame);

/// Sets the material. Wireframe, depth and texture coordinates show every material opaque.
void set_material(kernels::DrawParams& params, const scene::Material& material, const TexelBuffer& texture);

/// True for what must be drawn triangle after triangle: masks, for the depth of what they drop, and blending.
bool is_drawn_in_order(const kernels::DrawParams& params);

}  // namespace tessera::raster
