// Micro-benchmarks of the stages that cost: control nets and emission of 20,000 triangle patches, on every device.
//
//   build/release/bench_stages --benchmark_filter=pn --benchmark_repetitions=5
//
// Buffers are allocated and kernels compiled before the clock starts; each iteration submits and waits.
#include "tessera.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

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
