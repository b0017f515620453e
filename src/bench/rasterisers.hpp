// What draws for the bench. This room names neither backends nor the portable rasteriser: the program gives both.
#pragma once

#include "gpu/device.hpp"
#include "render/rasteriser.hpp"

#include <functional>
#include <memory>

namespace tessera::bench {

using OpenRasteriser = std::function<std::unique_ptr<render::Rasteriser>(const gpu::Device&)>;

/// Each may be empty: nothing is drawn with it.
struct Rasterisers {
    OpenRasteriser own;       ///< the device's own; null for devices without
    OpenRasteriser portable;  ///< by kernels, on any device
};

}  // namespace tessera::bench
