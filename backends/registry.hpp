// The only place that names backends.
#pragma once

#include "backends/inventory.hpp"
#include "bench/timed_draw.hpp"
#include "gpu/device.hpp"
#include "render/rasteriser.hpp"
#include "verify/fixed_function.hpp"

namespace tessera::backends {

/// What this machine has: reference first, then vulkan, then opencl. Never fails: what is missing is listed with its
/// reason.
Inventory list_devices();

/// Opens a device by what `--device` takes: "reference", "vulkan", "opencl", "vulkan:1", "vulkan:swiftshader" (part
/// of a name, case ignored), "opencl:0". Throws Error(usage) for words that name no backend, and
/// Error(device_unavailable) with what was found instead.
gpu::Device open_device(const std::string& id);

/// Opens a rasteriser: on the named device where it can draw, else (also for "") on the first device that can.
/// Throws Error(device_unavailable) where none can, with what was found.
std::unique_ptr<render::Rasteriser> open_rasteriser(const std::string& id = "");

/// Opens the rasteriser of an open device, which draws from the device's buffers too. Throws Error(device_unavailable)
/// where it has none.
std::unique_ptr<render::Rasteriser> open_rasteriser(const gpu::Device& device);

/// Opens the tessellation stage of the named device, or for "" of the first device that has one which can be captured.
/// Throws Error(device_unavailable) with every device's reason where none can.
std::unique_ptr<verify::FixedFunctionTessellator> open_fixed_function(const std::string& id = "");

/// Opens the tessellation stage of the named device to be timed. Throws Error(device_unavailable) where it has none.
std::unique_ptr<bench::TimedStage> open_timed_stage(const std::string& id);

}  // namespace tessera::backends
