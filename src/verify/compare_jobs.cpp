#include "verify/compare_jobs.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <memory>

namespace tessera::verify {
namespace {

using Words = std::vector<std::uint32_t>;

Words read(gpu::Device& device, const StageView& view) {
    Words words(view.bytes / 4);
    device.queue().read_buffer(view.buffer, 0, std::as_writable_bytes(std::span(words)));
    return words;
}

void note(StageComparison& stage, std::size_t at, std::uint32_t expected, std::uint32_t found, bool is_float) {
    if (stage.differing++ == 0) {
        stage.first = Difference{stage.words + at, expected, found, is_float};
    }
}

void compare(StageComparison& stage, const Words& expected, const Words& found, bool floats) {
    const bool same =
        expected.size() == found.size() && std::memcmp(expected.data(), found.data(), expected.size() * 4) == 0;
    for (std::size_t i = 0; i < found.size() && (!same || floats); ++i) {
        // An equal NaN on both sides is still wrong.
        if (i >= expected.size() || expected[i] != found[i] ||
            (floats && !std::isfinite(std::bit_cast<float>(found[i])))) {
            note(stage, i, i < expected.size() ? expected[i] : 0u, found[i], floats);
        }
    }
    if (found.size() < expected.size()) {
        note(stage, found.size(), expected[found.size()], 0u, floats);
    }
    stage.words += expected.size();
}

gpu::Limits common_limits(const std::vector<gpu::Device>& devices) {
    gpu::Limits limits = devices.front().limits();
    for (const gpu::Device& device : devices) {
        limits.max_storage_binding_size =
            std::min(limits.max_storage_binding_size, device.limits().max_storage_binding_size);
        limits.max_buffer_size = std::min(limits.max_buffer_size, device.limits().max_buffer_size);
    }
    return limits;
}

template <typename AnyJob>
struct Runner {
    gpu::Device device;
    std::unique_ptr<AnyJob> job;
};

template <typename AnyJob>
void compare_views(std::vector<Runner<AnyJob>>& runners, std::vector<DeviceComparison>& results,
                   std::vector<StageView> (AnyJob::*views)() const) {
    const std::vector<StageView> expected_views = (runners.front().job.get()->*views)();
    for (std::size_t v = 0; v < expected_views.size(); ++v) {
        const Words expected = read(runners.front().device, expected_views[v]);
        const auto stage = static_cast<std::size_t>(expected_views[v].stage);
        for (std::size_t i = 0; i < runners.size(); ++i) {
            const StageView view = (runners[i].job.get()->*views)()[v];
            compare(results[i].stages[stage], expected, i == 0 ? expected : read(runners[i].device, view), view.floats);
        }
    }
}

template <typename AnyJob, typename Input, typename Options>
std::vector<DeviceComparison> compare_any_jobs(const std::vector<gpu::Device>& devices, const Input& input,
                                               const Options& options, const std::function<void(double)>& progress) {
    assert(!devices.empty());
    const gpu::Limits limits = common_limits(devices);
    std::vector<Runner<AnyJob>> runners;
    std::vector<DeviceComparison> results;
    for (const gpu::Device& device : devices) {
        results.push_back({device.info(), {}});
        runners.push_back({device, std::make_unique<AnyJob>(device, input, options, limits)});
        runners.back().job->poison_outputs(0xa5a5a5a5u + static_cast<std::uint32_t>(runners.size()));
    }
    const std::size_t chunks = runners.front().job->chunk_count();
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        const std::vector<Batch>* batches = nullptr;
        for (Runner<AnyJob>& runner : runners) {
            runner.job->count(chunk);
            const std::vector<Batch>& own = runner.job->prepare();
            batches = batches == nullptr ? &own : batches;
        }
        compare_views(runners, results, &AnyJob::prepared_views);
        if (!std::ranges::all_of(results, [](const DeviceComparison& result) {
                return result.stages[static_cast<std::size_t>(StageId::scan)].differing == 0;
            })) {
            return results;  // other offsets make other batches
        }
        for (std::size_t b = 0; b < batches->size(); ++b) {
            for (Runner<AnyJob>& runner : runners) {
                runner.job->emit((*batches)[b], 0);
            }
            compare_views(runners, results, &AnyJob::emitted_views);
            if (progress) {
                progress(
                    (static_cast<double>(chunk) + static_cast<double>(b + 1) / static_cast<double>(batches->size())) /
                    static_cast<double>(chunks));
            }
        }
    }
    return results;
}

}  // namespace

bool DeviceComparison::equal() const {
    return std::ranges::all_of(stages, [](const StageComparison& stage) { return stage.differing == 0; });
}

std::vector<DeviceComparison> compare_jobs(const std::vector<gpu::Device>& devices, const patches::PatchSet& patches,
                                           const TessellationOptions& options,
                                           const std::function<void(double)>& progress) {
    return compare_any_jobs<Job>(devices, patches, options, progress);
}

std::vector<DeviceComparison> compare_hair_jobs(const std::vector<gpu::Device>& devices, const patches::HairSet& hair,
                                                const HairOptions& options,
                                                const std::function<void(double)>& progress) {
    return compare_any_jobs<HairJob>(devices, hair, options, progress);
}

std::string describe(const Difference& d) {
    if (d.is_float) {
        return fmt::format("element {}: {:08x} ({}) expected, {:08x} ({}) found", d.element, d.expected,
                           std::bit_cast<float>(d.expected), d.found, std::bit_cast<float>(d.found));
    }
    return fmt::format("element {}: {:08x} expected, {:08x} found", d.element, d.expected, d.found);
}

}  // namespace tessera::verify
