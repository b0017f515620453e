#include "bench/marks.hpp"

#include "bench/drawing.hpp"
#include "bench/growth.hpp"

#include <fmt/format.h>
#include <algorithm>

namespace tessera::bench {
namespace {

const gpu::DeviceInfo* find_device(const Report& report, auto&& predicate) {
    const auto found = std::ranges::find_if(report.devices, predicate);
    return found == report.devices.end() ? nullptr : &*found;
}

class Marks {
public:
    explicit Marks(const Report& report) : report_(report) {}

    void fraction(const std::string& name, const std::string& workload, const std::string& device, double mark) {
        const Figure* figure = report_.find_figure(workload, device);
        add(name, figure == nullptr ? std::nullopt : figure->roof_fraction, "of the roof", mark, true);
    }

    /// How many times faster `fast` is than `slow`.
    void ratio(const std::string& name, const std::string& workload, const std::string& fast, const std::string& slow,
               double mark) {
        const Figure* a = report_.find_figure(workload, fast);
        const Figure* b = report_.find_figure(workload, slow);
        std::optional<double> value;
        if (a != nullptr && b != nullptr && a->seconds.median > 0.0) {
            value = b->seconds.median / a->seconds.median;
        }
        add(name, value, "x", mark, true);
    }

    void add(const std::string& name, std::optional<double> value, const std::string& unit, double mark,
             bool at_least) {
        list_.push_back({name, value, unit, mark, at_least});
    }

    std::vector<Mark> take() { return std::move(list_); }

private:
    const Report& report_;
    std::vector<Mark> list_;
};

// The fixed cost of a job is a cell of the table of growth.
std::optional<double> fixed_cost(const Report& report, const std::string& device) {
    const auto table = std::ranges::find(report.tables, "W6", &Table::id);
    if (table == report.tables.end()) return std::nullopt;
    const auto column = std::ranges::find(table->columns, one_patch_column);
    for (const std::vector<Cell>& row : table->rows) {
        const auto* id = std::get_if<std::string>(&row.front());
        if (id != nullptr && *id == device && column != table->columns.end()) {
            const Cell& cell = row[static_cast<std::size_t>(column - table->columns.begin())];
            if (const auto* value = std::get_if<double>(&cell)) return *value;
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<Mark> make_marks(const Report& report) {
    const auto* pocl = find_device(report, [](const auto& d) { return d.backend == "opencl" && d.software; });
    const auto* lavapipe = find_device(
        report, [](const auto& d) { return d.backend == "vulkan" && d.name.find("llvmpipe") != std::string::npos; });
    const std::string cl = pocl == nullptr ? "" : pocl->id;
    const std::string vk = lavapipe == nullptr ? "" : lavapipe->id;
    Marks marks(report);
    marks.fraction("W1 on PoCL, whole job, bytes written over the non-temporal write roof", "W1", cl, 0.50);
    marks.ratio("W1 on PoCL against the hand-written C++", "W1", cl, hand_written_peer, 1.0);
    marks.ratio("W1 on PoCL against lavapipe fixed function, captured", "W1", cl, captured_peer_prefix + vk, 40.0);
    marks.ratio("W1 on lavapipe compute against lavapipe fixed function, captured", "W1", vk, captured_peer_prefix + vk,
                8.0);
    marks.ratio("W1 on lavapipe compute against lavapipe fixed function, discarded", "W1", vk,
                discarded_peer_prefix + vk, 3.0);
    marks.fraction("W2 on PoCL, fraction of the roof", "W2", cl, 0.25);
    marks.ratio("W2 on PoCL against the serial one-patch-per-item kernel", "W2", cl, serial_peer_prefix + cl, 4.0);
    marks.ratio("W1 reference backend against the hand-written C++", "W1", "reference", hand_written_peer, 0.5);
    marks.add("W6 fixed cost of a job of 1 patch on PoCL, warm", fixed_cost(report, cl), "ms", 0.5, false);
    marks.ratio("W7 portable on PoCL against lavapipe's own rasteriser, mesh on the device, 4 samples", "W7",
                portable_contestant(cl, 4, false), own_contestant(vk, false), 4.0);
    marks.ratio("W7 reference against PoCL, portable, mesh on the device, 4 samples", "W7",
                portable_contestant("reference", 4, false), portable_contestant(cl, 4, false), 0.5);
    std::optional<double> memory;
    for (const Figure& figure : report.figures) {
        if (figure.workload == "W1" && figure.extra_memory) {
            memory = std::max(memory.value_or(0.0), *figure.extra_memory);
        }
    }
    marks.add("peak memory beyond outputs and inputs, W1, over the outputs", memory, "of the outputs", 0.10, false);
    for (const gpu::DeviceInfo& device : report.devices) {
        if (device.software || !device.tessellation_stage) continue;
        for (const char* workload : {"W1", "W1-64"}) {
            marks.ratio(fmt::format("{} on {} against its tessellation stage, discarded", workload, device.id),
                        workload, device.id, discarded_peer_prefix + device.id, 1.0);
            marks.ratio(fmt::format("{} on {} against its tessellation stage, drawn", workload, device.id), workload,
                        device.id, drawn_peer_prefix + device.id, 1.0);
        }
    }
    return marks.take();
}

}  // namespace tessera::bench
