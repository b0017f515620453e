// The report as bars.
#pragma once

#include "bench/report.hpp"
#include "image/image.hpp"

#include <string>

namespace tessera::bench {

/// Millions of triangles per second of every contestant, a group of bars per workload, each group to its own scale.
std::string plot_svg(const Report& report);
image::Image plot_image(const Report& report);

}  // namespace tessera::bench
