// How the rasteriser maps to work items. Pictures do not depend on it.
#pragma once

#include "gpu/types.hpp"

namespace tessera::raster {

/// CPUs run the 64 items of a group one after another on one thread: few busy items per group share the work evenly,
/// and an item walks a list once. GPUs want as many busy items as there can be.
struct Launch {
    std::uint32_t block = 4096;         ///< triangles that an item counts and sorts into lists
    std::uint32_t block_spread = 6;     ///< log2: every 2^n-th item has a block
    std::uint32_t tile_spread = 2;      ///< log2: every 2^n-th item has (a part of) a tile
    std::uint32_t tile_parts = 0;       ///< log2 of the items that share a tile
};

inline Launch choose_launch(const gpu::DeviceInfo& device) {
    return device.software ? Launch{} : Launch{256, 0, 0, 4};
}

}  // namespace tessera::raster
