#include "bench/report.hpp"

#include <nlohmann/json.hpp>

namespace tessera::bench {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Summary& s) {
    return {{"median", s.median}, {"lower_quartile", s.lower}, {"upper_quartile", s.upper},
            {"least", s.least},   {"greatest", s.greatest},    {"samples", s.samples}};
}

template <typename T>
Json optional_json(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json to_json(const gpu::DeviceInfo& d) {
    return {{"id", d.id},
            {"backend", d.backend},
            {"name", d.name},
            {"driver", d.driver},
            {"version", d.version},
            {"software", d.software},
            {"compute_units", d.compute_units},
            {"tessellation_stage", d.tessellation_stage}};
}

double per_second(std::uint64_t count, double seconds) {
    return seconds > 0.0 ? static_cast<double>(count) / seconds : 0.0;
}

Json to_json(const Figure& f) {
    Json stages = Json::object();
    for (const auto& [name, seconds] : f.stages) {
        stages[name] = to_json(seconds);
    }
    return {{"workload", f.workload},
            {"contestant", f.contestant},
            {"peer", f.peer},
            {"seconds", to_json(f.seconds)},
            {"vertices", f.vertices},
            {"triangles", f.triangles},
            {"bytes", f.bytes},
            {"vertices_per_second", per_second(f.vertices, f.seconds.median)},
            {"triangles_per_second", per_second(f.triangles, f.seconds.median)},
            {"bytes_per_second", per_second(f.bytes, f.seconds.median)},
            {"roof_fraction", optional_json(f.roof_fraction)},
            {"dispatches", optional_json(f.dispatches)},
            {"extra_memory", optional_json(f.extra_memory)},
            {"stage_seconds", stages},
            {"note", f.note},
            {"rejected", f.rejected}};
}

Json to_json(const Table& t) {
    Json rows = Json::array();
    for (const std::vector<Cell>& row : t.rows) {
        Json cells = Json::array();
        for (const Cell& cell : row) {
            std::visit([&](const auto& value) { cells.push_back(value); }, cell);
        }
        rows.push_back(cells);
    }
    return {{"id", t.id}, {"title", t.title}, {"note", t.note}, {"columns", t.columns}, {"rows", rows}};
}

}  // namespace

nlohmann::ordered_json to_json(const Report& report) {
    Json json{
        {"tessera", TESSERA_VERSION},
        {"quick", report.quick},
        {"machine", {{"cpu", report.cpu}, {"threads", report.threads}, {"streaming_stores", report.streaming_stores}}},
        {"devices", Json::array()},
        {"workloads", Json::object()},
        {"roofs", Json::array()},
        {"figures", Json::array()},
        {"tables", Json::array()},
        {"marks", Json::array()},
        {"missing", Json::array()}};
    for (const gpu::DeviceInfo& device : report.devices) {
        json["devices"].push_back(to_json(device));
    }
    for (const auto& [id, description] : report.workloads) {
        json["workloads"][id] = description;
    }
    for (const Roof& roof : report.roofs) {
        json["roofs"].push_back({{"workload", roof.workload},
                                 {"where", roof.where},
                                 {"name", roof.name},
                                 {"bytes", roof.bytes},
                                 {"bytes_per_second", to_json(roof.rate)}});
    }
    for (const Figure& figure : report.figures) {
        json["figures"].push_back(to_json(figure));
    }
    for (const Table& table : report.tables) {
        json["tables"].push_back(to_json(table));
    }
    for (const Mark& mark : report.marks) {
        json["marks"].push_back({{"name", mark.name},
                                 {"value", optional_json(mark.value)},
                                 {"unit", mark.unit},
                                 {"mark", mark.mark},
                                 {"at_least", mark.at_least},
                                 {"met", mark.met()}});
    }
    for (const Missing& missing : report.missing) {
        json["missing"].push_back({{"what", missing.what}, {"reason", missing.reason}});
    }
    return json;
}

}  // namespace tessera::bench
