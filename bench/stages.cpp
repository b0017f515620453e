// Micro-benchmarks of the stages and of whole jobs of 20,000 triangle patches, on every device.
//
//   build/release/bench_stages --benchmark_filter=pn --benchmark_repetitions=5
//
// Buffers are allocated and kernels compiled before the clock starts; each iteration submits and waits.
#include "tessera.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <array>
#include <chrono>

namespace {

using namespace tessera;

const patches::PatchSet& patch_set() {
    static const patches::PatchSet set =
        patches::make_patches(scene::load_scene("shape:sphere:50"));  // 8 * 50^2 patches
    return set;
}

TessellationOptions options_of(Scheme scheme, float factor) {
    TessellationOptions options;
    options.scheme = scheme;
    options.partitioning = Partitioning::integer;
    options.factors = PatchFactors{factor, factor, factor, factor, factor, factor};
    options.memory_budget = 1ull << 30;
    return options;
}

void control_nets(benchmark::State& state, const std::string& id, Scheme scheme) {
    gpu::Device device = backends::open_device(id);
    Job job(device, patch_set(), options_of(scheme, 1.0f), device.limits());
    job.count(0);
    job.prepare();
    for (auto _ : state) {
        job.prepare();
        device.queue().wait();
    }
    state.counters["patches/s"] = benchmark::Counter(static_cast<double>(job.chunk(0).patch_count),
                                                     benchmark::Counter::kIsIterationInvariantRate);
}

void counting(benchmark::State& state, const std::string& id, Scheme scheme) {
    gpu::Device device = backends::open_device(id);
    Job job(device, patch_set(), options_of(scheme, static_cast<float>(state.range(0))), device.limits());
    for (auto _ : state) {
        job.count(0);
    }
    state.counters["patches/s"] = benchmark::Counter(static_cast<double>(job.chunk(0).patch_count),
                                                     benchmark::Counter::kIsIterationInvariantRate);
}

/// A job as `tessera bench` runs it, and how long the host waits in each of its steps.
void whole_job(benchmark::State& state, const std::string& id, Scheme scheme) {
    using Clock = std::chrono::steady_clock;
    gpu::Device device = backends::open_device(id);
    Job job(device, patch_set(), options_of(scheme, static_cast<float>(state.range(0))), device.limits());
    std::uint64_t vertices = 0;
    std::array<Clock::duration, 3> steps{};
    job.count(0);
    job.prepare();  // reserves the output
    for (auto _ : state) {
        const Clock::time_point start = Clock::now();
        job.count(0);
        const Clock::time_point counted = Clock::now();
        const std::vector<Batch>& batches = job.prepare();
        const Clock::time_point prepared = Clock::now();
        vertices = 0;
        for (const Batch& batch : batches) {
            job.emit(batch, 0);
            vertices += batch.vertex_count;
        }
        device.queue().wait();
        steps[0] += counted - start;
        steps[1] += prepared - counted;
        steps[2] += Clock::now() - prepared;
    }
    const auto seconds = [](Clock::duration d) {
        return benchmark::Counter(std::chrono::duration<double>(d).count(), benchmark::Counter::kAvgIterations);
    };
    state.counters["count"] = seconds(steps[0]);
    state.counters["prepare"] = seconds(steps[1]);
    state.counters["emit"] = seconds(steps[2]);
    state.counters["vertices/s"] =
        benchmark::Counter(static_cast<double>(vertices), benchmark::Counter::kIsIterationInvariantRate);
}

void emission(benchmark::State& state, const std::string& id, Scheme scheme) {
    gpu::Device device = backends::open_device(id);
    Job job(device, patch_set(), options_of(scheme, static_cast<float>(state.range(0))), device.limits());
    job.count(0);
    const Batch batch = job.prepare().front();
    job.emit(batch, 0);
    for (auto _ : state) {
        job.emit(batch, 0);
        device.queue().wait();
    }
    using benchmark::Counter;
    state.counters["vertices/s"] = Counter(batch.vertex_count, Counter::kIsIterationInvariantRate);
    state.counters["bytes/s"] =
        Counter(static_cast<double>(batch.vertex_count * sizeof(Vertex) + batch.index_count * 4.0),
                Counter::kIsIterationInvariantRate, Counter::kIs1024);
}

}  // namespace

int main(int argc, char** argv) {
    for (const gpu::DeviceInfo& info : backends::list_devices().devices) {
        benchmark::AddCustomContext(info.id,
                                    fmt::format("{}, {}{}", info.name, info.driver, info.software ? ", software" : ""));
        for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn, Scheme::stpn}) {
            const std::string what = fmt::format("{}/{}", info.id, name(scheme));
            benchmark::RegisterBenchmark((what + "/control_nets").c_str(), control_nets, info.id, scheme)
                ->UseRealTime();
            benchmark::RegisterBenchmark((what + "/emission").c_str(), emission, info.id, scheme)
                ->Arg(1)
                ->Arg(16)
                ->UseRealTime()
                ->Unit(benchmark::kMillisecond);
            benchmark::RegisterBenchmark((what + "/counting").c_str(), counting, info.id, scheme)
                ->Arg(16)
                ->UseRealTime();
            benchmark::RegisterBenchmark((what + "/whole_job").c_str(), whole_job, info.id, scheme)
                ->Arg(16)
                ->UseRealTime()
                ->Unit(benchmark::kMillisecond);
        }
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
