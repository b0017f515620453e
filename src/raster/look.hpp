// The words of a texture buffer that tell kernels how to light: of the picture, and of a material
// (kernels/raster/raster_layout.h).
#pragma once

#include "raster/raster_layout.h"
#include "render/rasteriser.hpp"

#include <array>
#include <span>

namespace tessera::raster {

/// The words from LOOK_AT to TEXELS_AT.
using Look = std::array<std::uint32_t, TEXELS_AT - LOOK_AT>;

/// A map of a material, and what kernels know it by.
struct MapUse {
    std::uint32_t kind = 0;  ///< MAP_...
    scene::Map map;
    float strength = 1.0f;
};

/// What all materials of a picture share. Lights beyond LIGHTS_MAX are left out; numbers that make no sense are
/// replaced by ones that do.
Look make_look(const render::Frame& frame);

/// The maps of a material in the order in which kernels apply them.
std::vector<MapUse> maps_of(const scene::Material& material);

/// Adds a material's factors and its maps but for their places among the texels (set_map_levels).
void set_material(Look& look, const scene::Material& material);

/// Sets size and places of map `number`; `levels` has the first word of each.
void set_map_levels(Look& look, std::size_t number, std::uint32_t width, std::uint32_t height,
                    std::span<const std::uint32_t> levels);

}  // namespace tessera::raster
