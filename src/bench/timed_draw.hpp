// A device's own tessellation stage as a peer. Implemented by backends that have such a stage (Vulkan).
#pragma once

#include "base/vertex.hpp"
#include "gpu/types.hpp"
#include "tessellate/options.hpp"

#include <memory>
#include <span>
#include <vector>

namespace tessera::bench {

/// Where that goes which the stage makes: into a buffer by transform feedback, as a list of three vertices of 32 bytes
/// per triangle; nowhere, by rasteriser discard; or into an image of 1024 x 1024 pixels.
enum class Destination { captured, discarded, drawn };

/// PN triangles with quadratic normals, over three corners and one set of factors per patch. Positions lie within 2 of
/// the origin.
struct TimedPatches {
    Partitioning partitioning = Partitioning::integer;
    std::span<const PatchFactors> factors;
    std::span<const Vertex> corners;
    std::uint32_t draw_patches = 100;  ///< of one draw
    std::uint64_t most_triangles = 0;  ///< of one patch, at most
};

/// Patches made ready to be drawn again and again.
class TimedDraw {
public:
    virtual ~TimedDraw() = default;
    /// Draws all patches once and waits. Throws Error(device_unavailable).
    virtual void run() = 0;
    /// Triangles that the last run captured; 0 unless that is where they went.
    virtual std::uint64_t captured_triangles() = 0;
    /// The first vertices that are in the capture buffer now, three per triangle.
    virtual std::vector<Vertex> captured(std::size_t count) = 0;
};

/// The stage of one device.
class TimedStage {
public:
    virtual ~TimedStage() = default;
    virtual const gpu::DeviceInfo& info() const = 0;
    /// Throws Error(usage) for a partitioning that the stage lacks, Error(device_unavailable) when the device fails.
    virtual std::unique_ptr<TimedDraw> prepare(Destination destination, const TimedPatches& patches) = 0;
};

}  // namespace tessera::bench
