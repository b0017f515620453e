#include "bench/report_grids.hpp"

#include <fmt/format.h>
#include <iterator>

namespace tessera::bench {
namespace {

std::string cell_text(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '|') result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result;
}

void append(std::string& text, const Grid& grid, const char* level) {
    if (grid.rows.size() < 2) return;
    fmt::format_to(std::back_inserter(text), "\n{} {}\n\n", level, grid.title);
    if (!grid.note.empty()) fmt::format_to(std::back_inserter(text), "{}\n\n", grid.note);
    for (std::size_t r = 0; r < grid.rows.size(); ++r) {
        text += "|";
        for (const std::string& cell : grid.rows[r]) {
            fmt::format_to(std::back_inserter(text), " {} |", cell_text(cell));
        }
        text += "\n";
        if (r == 0) {
            text += "|";
            for (std::size_t c = 0; c < grid.rows[r].size(); ++c) {
                text += "---|";
            }
            text += "\n";
        }
    }
}

}  // namespace

std::string to_markdown(const Report& report, const std::string& remarks) {
    std::string text = fmt::format(
        "# Performance\n\nWritten by `tessera bench --markdown`, all in one run: contestants take turns, medians of "
        "{} rounds at most, with quartiles. Do not edit.\n",
        report.figures.empty() ? 0 : report.figures.front().seconds.samples);
    if (report.quick) text += "\n**A quick run: small workloads, not to be quoted.**\n";
    text += "\n## Machine\n\n";
    for (const gpu::DeviceInfo& device : report.devices) {
        text += "- " + describe(device) + "\n";
    }
    fmt::format_to(std::back_inserter(text), "- {} threads; non-temporal stores: {}\n", report.threads,
                   report.streaming_stores);
    append(text, mark_grid(report), "##");
    if (!remarks.empty()) text += "\n" + remarks;
    append(text, roof_grid(report), "##");
    for (const Grid& grid : figure_grids(report)) {
        append(text, grid, "##");
    }
    for (const Grid& grid : stage_grids(report)) {
        append(text, grid, "###");
    }
    for (const Grid& grid : table_grids(report)) {
        append(text, grid, "##");
    }
    if (!report.missing.empty()) text += "\n## Missing\n\n";
    for (const Missing& missing : report.missing) {
        fmt::format_to(std::back_inserter(text), "- {}: {}\n", missing.what, missing.reason);
    }
    return text;
}

}  // namespace tessera::bench
