#include "raster/raster_window.hpp"

#include "raster/raster_layout.h"

#include <algorithm>

namespace tessera::raster {

std::vector<RasterWindow> make_windows(gpu::Device& device, std::uint32_t width, std::uint32_t height,
                                       std::uint32_t samples, std::uint32_t side) {
    constexpr auto usage =
        gpu::BufferUsage::storage | gpu::BufferUsage::copy_destination | gpu::BufferUsage::copy_source;
    std::vector<RasterWindow> windows;
    for (std::uint32_t y = 0; y < height; y += side) {
        for (std::uint32_t x = 0; x < width; x += side) {
            RasterWindow window;
            window.x = x;
            window.y = y;
            window.width = std::min(width - x, side);
            window.height = std::min(height - y, side);
            window.tiles_x = (window.width + RASTER_TILE - 1) / RASTER_TILE;
            window.tiles_y = (window.height + RASTER_TILE - 1) / RASTER_TILE;
            const std::uint64_t bytes = std::uint64_t{window.tiles()} * RASTER_TILE_PIXELS * samples * 4;
            window.depths = device.create_buffer({"depths of samples", bytes, usage});
            window.colours = device.create_buffer({"colours of samples", bytes, usage});
            windows.push_back(std::move(window));
        }
    }
    return windows;
}

}  // namespace tessera::raster
