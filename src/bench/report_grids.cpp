#include "bench/report_grids.hpp"

#include <fmt/format.h>

namespace tessera::bench {
namespace {

std::string milliseconds(const Summary& s) {
    return fmt::format("{:.3g}", s.median * 1e3);
}

// Quartiles, as what half of the samples lie between.
std::string spread(const Summary& s) {
    return fmt::format("{:.3g} to {:.3g}", s.lower * 1e3, s.upper * 1e3);
}

std::string millions(std::uint64_t count, double seconds) {
    return seconds > 0.0 ? fmt::format("{:.4g}", static_cast<double>(count) / seconds * 1e-6) : "-";
}

std::string text(const Cell& cell) {
    if (const auto* value = std::get_if<double>(&cell)) return fmt::format("{:.4g}", *value);
    return std::get<std::string>(cell);
}

std::vector<std::string> figure_row(const Figure& f) {
    if (!f.rejected.empty()) {
        return {f.contestant, "rejected", "-", "-", "-", "-", "-", "-", f.rejected};
    }
    return {f.contestant,
            milliseconds(f.seconds),
            spread(f.seconds),
            millions(f.vertices, f.seconds.median),
            millions(f.triangles, f.seconds.median),
            fmt::format("{:.1f}", static_cast<double>(f.bytes) * 1e-6),
            f.roof_fraction ? fmt::format("{:.3f}", *f.roof_fraction) : "-",
            f.dispatches ? fmt::format("{}", *f.dispatches) : "-",
            f.note};
}

}  // namespace

std::string describe(const gpu::DeviceInfo& d) {
    return fmt::format("{} ({}, {}{}{})", d.id, d.name, d.driver, d.version.empty() ? "" : " " + d.version,
                       d.software ? ", software" : "");
}

Grid roof_grid(const Report& report) {
    Grid grid{
        "Roofs", "GB/s; a copy's bytes count once.", {{"beside", "where", "what", "median", "quartiles", "best"}}};
    for (const Roof& roof : report.roofs) {
        grid.rows.push_back({roof.workload, roof.where, roof.name, fmt::format("{:.1f}", roof.rate.median * 1e-9),
                             fmt::format("{:.1f} to {:.1f}", roof.rate.lower * 1e-9, roof.rate.upper * 1e-9),
                             fmt::format("{:.1f}", roof.rate.greatest * 1e-9)});
    }
    return grid;
}

std::vector<Grid> figure_grids(const Report& report) {
    std::vector<Grid> grids;
    for (const auto& [id, description] : report.workloads) {
        Grid grid{fmt::format("{}: {}", id, description), "", {}};
        for (const Figure& figure : report.figures) {
            if (figure.workload == id) grid.rows.push_back(figure_row(figure));
        }
        if (grid.rows.empty()) continue;
        grid.rows.insert(grid.rows.begin(), {"contestant", "ms", "quartiles", "Mverts/s", "Mtris/s", "MB", "of roof",
                                             "dispatches", "note"});
        grids.push_back(std::move(grid));
    }
    return grids;
}

std::vector<Grid> stage_grids(const Report& report) {
    std::vector<Grid> grids;
    for (const auto& [id, description] : report.workloads) {
        Grid grid{fmt::format("{} by stage, device ms", id), "", {}};
        for (const Figure& figure : report.figures) {
            if (figure.workload != id || figure.stages.empty()) continue;
            if (grid.rows.empty()) {
                grid.rows.push_back({"device"});
                for (const auto& [name, seconds] : figure.stages) {
                    grid.rows.front().push_back(name);
                }
            }
            grid.rows.push_back({figure.contestant});
            for (const auto& [name, seconds] : figure.stages) {
                grid.rows.back().push_back(milliseconds(seconds));
            }
        }
        if (!grid.rows.empty()) grids.push_back(std::move(grid));
    }
    return grids;
}

Grid mark_grid(const Report& report) {
    Grid grid{"Marks", "", {{"what", "value", "mark", "met"}}};
    for (const Mark& mark : report.marks) {
        grid.rows.push_back({mark.name, mark.value ? fmt::format("{:.3g} {}", *mark.value, mark.unit) : "not measured",
                             fmt::format("{} {:g}", mark.at_least ? ">=" : "<=", mark.mark),
                             mark.value ? (mark.met() ? "yes" : "no") : "-"});
    }
    return grid;
}

std::vector<Grid> table_grids(const Report& report) {
    std::vector<Grid> grids;
    for (const Table& table : report.tables) {
        Grid grid{fmt::format("{}: {}", table.id, table.title), table.note, {table.columns}};
        for (const std::vector<Cell>& row : table.rows) {
            grid.rows.emplace_back();
            for (const Cell& cell : row) {
                grid.rows.back().push_back(text(cell));
            }
        }
        grids.push_back(std::move(grid));
    }
    return grids;
}

}  // namespace tessera::bench
