// W7: a mesh of millions of triangles, many of them smaller than a pixel, drawn by every device.
#pragma once

#include "bench/contest.hpp"
#include "bench/rasterisers.hpp"
#include "bench/report.hpp"

#include <string>

namespace tessera::bench {

/// Adds workload W7, the figures of its largest mesh, and a table of growth. The mesh is shape:sphere:50 with 16
/// segments to an edge, 5.12 million triangles, at 1024 x 1024 (quick: 12,800 triangles).
void measure_drawing(Report& report, const std::vector<gpu::Device>& devices, const Effort& effort,
                     const Rasterisers& rasterisers, bool quick);

/// Names of contestants. The mesh lies on the device, or where it is `uploaded` in host memory.
std::string portable_contestant(const std::string& device, std::uint32_t samples, bool uploaded);
/// With 4 samples.
std::string own_contestant(const std::string& device, bool uploaded);

}  // namespace tessera::bench
