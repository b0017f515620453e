// The tessellation stage, timed: draws that are captured, discarded or rasterised.
#pragma once

#include <cstddef>
#include <memory>

#include "bench/timed_draw.hpp"

namespace tessera::backends::vulkan {

/// Opens the stage of device `index` of list(). Throws Error(device_unavailable) where it has none.
std::unique_ptr<bench::TimedStage> open_timed_stage(std::size_t index);

}  // namespace tessera::backends::vulkan
