// What a run of the bench found, as data, and its forms.
#pragma once

#include "bench/statistics.hpp"
#include "gpu/types.hpp"

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tessera::bench {

/// A rate that nothing beats: bytes per second, of the host ("host") or of a device (its id).
struct Roof {
    std::string workload;  ///< beside which it was measured
    std::string where;
    std::string name;
    Summary rate;
    std::uint64_t bytes = 0;  ///< of one sample
};

/// The host's roof that fractions are of.
inline constexpr const char* streaming_roof_name = "write, non-temporal";

/// One contestant's time for one workload.
struct Figure {
    std::string workload;
    std::string contestant;  ///< a device's id, or the name of a peer
    bool peer = false;
    Summary seconds;  ///< of the whole workload
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t bytes = 0;  ///< written: vertices and triangles
    std::optional<double> roof_fraction;
    std::optional<std::uint64_t> dispatches;
    std::optional<double> extra_memory;                   ///< beyond inputs and outputs, over the outputs
    std::vector<std::pair<std::string, Summary>> stages;  ///< device seconds
    std::string note;
    std::string rejected;  ///< why the figure does not count; empty where it does
    bool unsound = false;  ///< rejected because the output is wrong
};

/// A value that is aimed for.
struct Mark {
    std::string name;
    std::optional<double> value;  ///< empty where it could not be measured here
    std::string unit;
    double mark = 0.0;
    bool at_least = true;  ///< else at most
    bool met() const { return value && (at_least ? *value >= mark : *value <= mark); }
};

using Cell = std::variant<std::string, double>;

/// Anything else that is measured, as rows.
struct Table {
    std::string id;  ///< "W5"
    std::string title, note;
    std::vector<std::string> columns;
    std::vector<std::vector<Cell>> rows;
};

struct Missing {
    std::string what, reason;
};

struct Report {
    bool quick = false;
    std::string cpu;
    unsigned threads = 0;
    std::string streaming_stores;
    std::vector<gpu::DeviceInfo> devices;
    std::vector<std::pair<std::string, std::string>> workloads;  ///< id, description
    std::vector<Roof> roofs;
    std::vector<Figure> figures;
    std::vector<Table> tables;
    std::vector<Mark> marks;
    std::vector<Missing> missing;

    const Roof* find_roof(const std::string& workload, const std::string& where, const std::string& name) const;
    /// Null where there is none or it was rejected.
    const Figure* find_figure(const std::string& workload, const std::string& contestant) const;
};

nlohmann::ordered_json to_json(const Report& report);
/// For a terminal.
std::string to_text(const Report& report);
/// A whole document. `remarks` (Markdown) is put under the table of marks.
std::string to_markdown(const Report& report, const std::string& remarks = {});

/// The name and state of a device for tables: "opencl:0 (pthread-..., Portable Computing Language 3.1, software)".
std::string describe(const gpu::DeviceInfo& device);

}  // namespace tessera::bench
