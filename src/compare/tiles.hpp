// Pictures are worked on tile by tile: memory does not grow with them, and tiles suit threads and caches.
#pragma once

#include <oneapi/tbb/parallel_for.h>
#include <algorithm>
#include <cstdint>

namespace tessera::compare {

/// Pixels [x, x + width) by [y, y + height).
struct Tile {
    std::int64_t x, y, width, height;
};

inline constexpr std::int64_t tile_width = 256, tile_height = 128;

inline std::size_t tile_count(std::uint32_t width, std::uint32_t height) {
    const auto count = [](std::int64_t size, std::int64_t tile) { return (size + tile - 1) / tile; };
    return static_cast<std::size_t>(count(width, tile_width) * count(height, tile_height));
}

/// Calls work(number, tile) for all tiles of a picture on all threads. Sums that are kept per number and added in their
/// order afterwards do not depend on timing.
template <typename Work>
void for_each_tile(std::uint32_t width, std::uint32_t height, const Work& work) {
    const std::size_t columns = tile_count(width, 1);
    tbb::parallel_for(std::size_t{0}, tile_count(width, height), [&](std::size_t number) {
        const auto x = static_cast<std::int64_t>(number % columns) * tile_width;
        const auto y = static_cast<std::int64_t>(number / columns) * tile_height;
        work(number, Tile{x, y, std::min(tile_width, std::int64_t{width} - x),
                          std::min(tile_height, std::int64_t{height} - y)});
    });
}

}  // namespace tessera::compare
