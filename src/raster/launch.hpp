// How the rasteriser maps to work items. Pictures do not depend on it.
#pragma once

#include "gpu/types.hpp"

namespace tessera::raster {

/// CPUs run the 64 items of a group one after another on one thread: few busy items per group share the work evenly,
/// and an item walks a list once. GPUs want as many busy items as there can be.
struct Launch {
    std::uint32_t triangles = 1u << 19;  ///< of a batch, which is set up, sorted and drawn at a time
    std::uint32_t block = 16384;         ///< triangles that an item counts and sorts into lists
    std::uint32_t block_spread = 6;      ///< log2: every 2^n-th item has a block
    std::uint32_t tile_spread = 6;       ///< log2: every 2^n-th item has (a part of) a tile
    std::uint32_t tile_parts = 0;        ///< log2 of the items that share a tile
    std::uint32_t entries = 1u << 20;    ///< triangles of a tile that a dispatch draws
    std::uint32_t window = 2048;         ///< longest side of a window in pixels
    std::uint32_t elements = 16;         ///< vertices, triangles or pixels of an item; a power of two up to 16
    std::uint32_t shaded = 64;           ///< pixels of an item that shades; a power of two up to 256
    std::uint32_t shade_spread = 2;      ///< log2: every 2^n-th item shades
};

inline Launch choose_launch(const gpu::DeviceInfo& device) {
    if (!device.software) return Launch{1u << 17, 256, 0, 0, 4, 1u << 14, 2048, 1, 1, 0};
    // Mesa's llvmpipe silently ends all loops of an item after 65,535 iterations together. At most 1024 tiles per
    // window and 48 triangles that touch all of them, or 128 polygons of 6 triangles in a row of 16 pixels, stay below.
    if (device.backend == "vulkan") return Launch{1u << 17, 48, 0, 0, 4, 128, 512, 1, 1, 0};
    return Launch{};
}

}  // namespace tessera::raster
