// The report as grids of text: what the terminal and the document show.
#pragma once

#include "bench/report.hpp"

namespace tessera::bench {

/// Rows of equal length, the first the headings.
struct Grid {
    std::string title, note;
    std::vector<std::vector<std::string>> rows;
};

Grid roof_grid(const Report& report);
/// One per workload: time, rates, bytes, fraction of the roof, dispatches.
std::vector<Grid> figure_grids(const Report& report);
/// Device milliseconds per stage, of every device that has timestamps.
std::vector<Grid> stage_grids(const Report& report);
Grid mark_grid(const Report& report);
std::vector<Grid> table_grids(const Report& report);

}  // namespace tessera::bench
