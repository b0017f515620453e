// W6: how time grows with the number of patches.
#pragma once

#include "bench/contest.hpp"
#include "bench/report.hpp"
#include "gpu/device.hpp"

#include <span>
#include <string>

namespace tessera::bench {

/// Jobs of 1, 10, 100, ... up to 1 million patches (quick: 1000) at factor 4 on every device: milliseconds each, and
/// the line time = fixed + slope * patches that fits them best by relative error.
Table measure_growth(const std::vector<gpu::Device>& devices, const Effort& effort, bool quick);

/// What tables of growth have after the columns of sizes, and what they say of it. `element` is what there are more of.
void add_growth_columns(Table& table, const std::string& element);
inline constexpr const char* growth_note = "Medians; the fit is a line through all sizes by relative error.";
/// A row: the name, milliseconds at each size, and the line.
std::vector<Cell> growth_row(const std::string& name, std::span<const double> counts, std::span<const double> seconds);

/// The column of its table that the mark on the fixed cost of a job reads.
inline constexpr const char* one_patch_column = "1 patch, ms";

}  // namespace tessera::bench
