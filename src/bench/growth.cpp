#include "bench/growth.hpp"

#include "bench/job_run.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>

namespace tessera::bench {
namespace {

Workload patches_of(std::uint64_t count, const patches::PatchSet& base) {
    Workload workload{"W6", fmt::format("{} patches", count), base, {}, 4.0f};
    workload.patches.corners.resize(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        workload.patches.corners[i] = base.corners[i % base.corners.size()];
    }
    workload.patches.ranges = {{"growth", 0, 0, count}};
    workload.options.partitioning = Partitioning::integer;
    workload.options.factors = equal_factors(4.0f);
    workload.options.memory_budget = 1ull << 30;
    return workload;
}

std::string heading(std::uint64_t count) {
    return count == 1 ? one_patch_column : fmt::format("{:.0e}, ms", static_cast<double>(count));
}

}  // namespace

Table measure_growth(const std::vector<gpu::Device>& devices, const Effort& effort, bool quick) {
    const patches::PatchSet base =
        patches::make_patches(scene::load_scene(quick ? "shape:sphere:5" : "shape:sphere:50"));
    Table table{"W6", "growth from 1 patch to many, factor 4, integer", growth_note, {"device"}, {}};
    std::vector<double> counts;
    std::vector<std::vector<double>> medians(devices.size());
    for (std::uint64_t count = 1; count <= (quick ? 1000u : 1000000u); count *= 10) {
        const Workload workload = patches_of(count, base);
        std::vector<std::unique_ptr<JobRun>> jobs;
        std::vector<Contestant> contestants;
        for (const gpu::Device& device : devices) {
            jobs.push_back(std::make_unique<JobRun>(device, workload));
            contestants.push_back({device.info().id, [job = jobs.back().get()] { job->run(); }});
        }
        Effort enough = effort;
        enough.repetitions = count <= 1000 ? 4 * effort.repetitions : effort.repetitions;
        interleave(contestants, enough);
        counts.push_back(static_cast<double>(count));
        table.columns.push_back(heading(count));
        for (std::size_t d = 0; d < devices.size(); ++d) {
            medians[d].push_back(summarise(contestants[d].seconds).median);
        }
    }
    add_growth_columns(table, "patch");
    for (std::size_t d = 0; d < devices.size(); ++d) {
        table.rows.push_back(growth_row(devices[d].info().id, counts, medians[d]));
    }
    return table;
}

void add_growth_columns(Table& table, const std::string& element) {
    table.columns.insert(table.columns.end(),
                         {"fixed by fit, ms", fmt::format("slope, ns per {}", element), "r squared"});
}

std::vector<Cell> growth_row(const std::string& name, std::span<const double> counts, std::span<const double> seconds) {
    std::vector<Cell> row{name};
    std::vector<double> weights;
    for (const double s : seconds) {
        row.emplace_back(s * 1e3);
        weights.push_back(1.0 / (s * s));
    }
    const Line line = fit_line(counts, seconds, weights);
    row.emplace_back(line.constant * 1e3);
    row.emplace_back(line.slope * 1e9);
    row.emplace_back(fit_line(counts, seconds).r_squared);
    return row;
}

}  // namespace tessera::bench
