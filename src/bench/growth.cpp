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
    Table table{"W6",
                "growth from 1 patch to many, factor 4, integer",
                "Medians of whole jobs; the fit is a line through all sizes by relative error.",
                {"device"},
                {}};
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
    table.columns.insert(table.columns.end(), {"fixed by fit, ms", "slope, ns per patch", "r squared"});
    for (std::size_t d = 0; d < devices.size(); ++d) {
        std::vector<Cell> row{devices[d].info().id};
        std::vector<double> weights;
        for (const double seconds : medians[d]) {
            row.emplace_back(seconds * 1e3);
            weights.push_back(1.0 / (seconds * seconds));
        }
        const Line line = fit_line(counts, medians[d], weights);
        row.emplace_back(line.constant * 1e3);
        row.emplace_back(line.slope * 1e9);
        row.emplace_back(fit_line(counts, medians[d]).r_squared);
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace tessera::bench
