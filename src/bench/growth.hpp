// W6: how time grows with the number of patches.
#pragma once

#include "bench/contest.hpp"
#include "bench/report.hpp"
#include "gpu/device.hpp"

namespace tessera::bench {

/// Jobs of 1, 10, 100, ... up to 1 million patches (quick: 1000) at factor 4 on every device: milliseconds each, and
/// the line time = fixed + slope * patches that fits them best by relative error.
Table measure_growth(const std::vector<gpu::Device>& devices, const Effort& effort, bool quick);

/// The column of its table that the mark on the fixed cost of a job reads.
inline constexpr const char* one_patch_column = "1 patch, ms";

}  // namespace tessera::bench
