#include "bench/report_grids.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <iterator>

namespace tessera::bench {
namespace {

void append(std::string& text, const Grid& grid) {
    if (grid.rows.size() < 2) return;
    std::vector<std::size_t> widths(grid.rows.front().size(), 0);
    for (const auto& row : grid.rows) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            widths[c] = std::max(widths[c], row[c].size());
        }
    }
    fmt::format_to(std::back_inserter(text), "\n{}\n", grid.title);
    if (!grid.note.empty()) fmt::format_to(std::back_inserter(text), "  {}\n", grid.note);
    for (const auto& row : grid.rows) {
        std::string line = " ";
        for (std::size_t c = 0; c < row.size(); ++c) {
            const bool last = c + 1 == row.size();
            line += c == 0 || last ? fmt::format(" {:<{}}", row[c], last ? 0 : widths[c])
                                   : fmt::format("  {:>{}}", row[c], widths[c]);
            if (c + 2 == row.size()) line += " ";
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
}

}  // namespace

std::string to_text(const Report& report) {
    std::string text;
    for (const gpu::DeviceInfo& device : report.devices) {
        text += describe(device) + "\n";
    }
    fmt::format_to(std::back_inserter(text), "{} threads, non-temporal stores: {}{}\n", report.threads,
                   report.streaming_stores, report.quick ? "; quick: small workloads, not to be quoted" : "");
    append(text, roof_grid(report));
    for (const Grid& grid : figure_grids(report)) {
        append(text, grid);
    }
    for (const Grid& grid : stage_grids(report)) {
        append(text, grid);
    }
    for (const Grid& grid : table_grids(report)) {
        append(text, grid);
    }
    append(text, mark_grid(report));
    for (const Missing& missing : report.missing) {
        fmt::format_to(std::back_inserter(text), "\n{} is missing: {}\n", missing.what, missing.reason);
    }
    return text;
}

}  // namespace tessera::bench
