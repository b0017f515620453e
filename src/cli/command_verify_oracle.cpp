#include "cli/command_verify_oracle.hpp"

#include "backends/registry.hpp"
#include "cli/progress.hpp"
#include "verify/oracle.hpp"

#include <fmt/format.h>
#include <array>
#include <bit>
#include <nlohmann/json.hpp>
#include <set>

namespace tessera::cli {
namespace {

using Json = nlohmann::ordered_json;

/// What one job on one device gave.
struct Findings {
    std::string device;
    std::array<verify::DomainComparison, 2> windings;  // cw, ccw
    verify::SurfaceComparison surface;

    bool equal() const { return windings[0].equal() && windings[1].equal() && surface.equal(); }
};

bool has_spacing(const std::string& partitioning) {
    const Partitioning chosen = partitioning_from_name(partitioning);
    return chosen != Partitioning::pow2 && chosen != Partitioning::uniform;
}

/// A pattern depends on its factors alone, so that equal sets need one comparison.
std::vector<PatchFactors> distinct_factors(const TessellationOptions& options) {
    if (const auto* one = std::get_if<PatchFactors>(&options.factors)) {
        return {*one};
    }
    using Bits = std::array<std::uint32_t, 6>;
    std::set<Bits> seen;
    std::vector<PatchFactors> distinct;
    for (const PatchFactors& factors : std::get<std::vector<PatchFactors>>(options.factors)) {
        if (seen.insert(std::bit_cast<Bits>(factors)).second) {
            distinct.push_back(factors);
        }
    }
    return distinct;
}

Findings compare(verify::FixedFunctionTessellator& stage, const gpu::Device& device, const patches::PatchSet& patches,
                 const TessellationOptions& options, const std::function<void(double)>& progress) {
    Findings findings{device.info().id, {}, {}};
    const std::vector<PatchFactors> factors = distinct_factors(options);
    for (const bool clockwise : {true, false}) {
        findings.windings[clockwise ? 0 : 1] =
            verify::compare_domain(stage, device, Domain::triangle, options.partitioning, clockwise, factors);
    }
    findings.surface = verify::compare_surface(stage, device, patches, options, progress);
    return findings;
}

std::string result(std::uint64_t differing, const char* fine) {
    return differing == 0 ? fine : fmt::format("{} patches differ", differing);
}

void print(const std::string& title, const std::vector<Findings>& all) {
    constexpr const char* row = "  {:<16}{:>10}{:>12}{:>14}{:>16}  {}\n";
    fmt::print("{}\n", title);
    fmt::print(row, "against stage", "device", "patches", "compared", "largest error", "");
    for (const Findings& findings : all) {
        for (std::size_t i = 0; i < findings.windings.size(); ++i) {
            const verify::DomainComparison& domain = findings.windings[i];
            fmt::print(row, i == 0 ? "triangles, cw" : "triangles, ccw", findings.device, domain.patches,
                       domain.primitives, "-", result(domain.differing, "same triangles"));
        }
        const verify::SurfaceComparison& surface = findings.surface;
        const std::string found = result(surface.differing, "within the bound");
        fmt::print(row, "positions", findings.device, surface.patches, surface.vertices,
                   fmt::format("{:.2e}", surface.position_error), found);
        fmt::print(row, "normals", findings.device, surface.patches, surface.vertices,
                   fmt::format("{:.2e}", surface.normal_error), found);
        for (const auto& first : {findings.windings[0].first, findings.windings[1].first, surface.first}) {
            if (first) {
                fmt::print("  {}\n", *first);
            }
        }
    }
}

Json to_json(const verify::DomainComparison& domain) {
    Json entry{{"patches", domain.patches}, {"triangles", domain.primitives}, {"differing", domain.differing}};
    if (domain.first) {
        entry["first"] = *domain.first;
    }
    return entry;
}

Json to_json(const Findings& findings) {
    const verify::SurfaceComparison& surface = findings.surface;
    Json entry{{"patches", surface.patches},
               {"vertices", surface.vertices},
               {"position_error", surface.position_error},
               {"normal_error", surface.normal_error},
               {"differing", surface.differing}};
    if (surface.first) {
        entry["first"] = *surface.first;
    }
    return {{"id", findings.device},
            {"cw", to_json(findings.windings[0])},
            {"ccw", to_json(findings.windings[1])},
            {"surface", entry}};
}

}  // namespace

int verify_with_oracle(const Context& context, const OracleWords& words) {
    const auto stage = backends::open_fixed_function();
    std::vector<gpu::Device> devices;
    for (const std::string& id : words.devices) {
        devices.push_back(backends::open_device(id));
    }
    Json documents = Json::array();
    std::size_t comparisons = 0;
    std::size_t different = 0;
    for (const std::string& input : words.inputs) {
        const patches::PatchSet patches = patches::make_patches(load(context, input, words.load));
        for (const JobWords& job : words.jobs) {
            if (words.skip_unsupported && !has_spacing(job.partitioning)) {
                say(context, fmt::format("{}: {} is skipped: the tessellation stage has no such spacing", input,
                                         job.partitioning));
                continue;
            }
            const TessellationOptions options = resolve(job, patches);
            Json document{{"input", input},          {"scheme", job.scheme},
                          {"normals", job.normals},  {"partitioning", job.partitioning},
                          {"factor", job.factor},    {"oracle", stage->info().name},
                          {"devices", Json::array()}};
            std::vector<Findings> all;
            for (const gpu::Device& device : devices) {
                Progress progress("comparing", context.quiet);
                all.push_back(compare(*stage, device, patches, options, progress.callback()));
                ++comparisons;
                different += all.back().equal() ? 0 : 1;
                document["devices"].push_back(to_json(all.back()));
            }
            if (!words.json) {
                print(fmt::format("{}: {} patches, {}, {} normals, {}, factor {}", input, patches.patch_count(),
                                  job.scheme, job.normals, job.partitioning, job.factor),
                      all);
            }
            documents.push_back(std::move(document));
        }
    }
    if (words.json) {
        fmt::print("{}\n", documents.dump(2));
    } else {
        fmt::print("{} comparisons with the tessellation stage of {} ({}), {} with differences\n", comparisons,
                   stage->info().id, stage->info().name, different);
        fmt::print(
            "Errors: of positions relative to the largest coordinate of a patch's corners, bound {:.2e}; of unit "
            "normals times the blended normal's length, bound {:.2e}\n",
            verify::position_error_bound, verify::normal_error_bound);
    }
    return different == 0 ? exit_fine : exit_difference;
}

}  // namespace tessera::cli
