// The rectangles of a picture that are drawn at a time: what a binding of 128 MiB holds.
#pragma once

#include "gpu/device.hpp"

#include <cstdint>
#include <vector>

namespace tessera::raster {

/// A rectangle of the picture and the depth and colour of its samples, 4 bytes each, tile after tile
/// (kernels/raster/raster_layout.h).
struct RasterWindow {
    std::uint32_t x = 0, y = 0;           ///< pixels, of the upper left corner
    std::uint32_t width = 0, height = 0;  ///< pixels
    std::uint32_t tiles_x = 0, tiles_y = 0;
    gpu::Buffer depths, colours;

    std::uint32_t tiles() const { return tiles_x * tiles_y; }
};

/// Windows of at most `side` pixels (a multiple of a tile) that cover a picture, row after row. `samples` is 1 or 4.
std::vector<RasterWindow> make_windows(gpu::Device& device, std::uint32_t width, std::uint32_t height,
                                       std::uint32_t samples, std::uint32_t side);

}  // namespace tessera::raster
