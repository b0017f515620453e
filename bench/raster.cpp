// Drawing: the portable rasteriser on every device, and the devices' own where they have one, of the same mesh at
// 1024 x 1024: shape:sphere:50 with 16 segments to an edge is 5.12 million triangles.
//
//   build/release/bench_raster --benchmark_filter=opencl --benchmark_repetitions=5
//
// The mesh lies in memory; an iteration uploads, draws and reads the picture back. Kernels are compiled before the
// clock starts.
#include "tessera.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <map>

namespace {

using namespace tessera;

const RefinedMesh& mesh_of(int segments) {
    static std::map<int, RefinedMesh> meshes;
    auto found = meshes.find(segments);
    if (found == meshes.end()) {
        TessellationOptions options;
        options.scheme = Scheme::pn;
        options.partitioning = Partitioning::uniform;
        const auto factor = static_cast<float>(segments);
        options.factors = PatchFactors{factor, factor, factor, factor, factor, factor};
        const patches::PatchSet set = patches::make_patches(scene::load_scene("shape:sphere:50"));
        found = meshes.emplace(segments, tessellate(backends::open_device("reference"), set, options)).first;
    }
    return found->second;
}

void draw(benchmark::State& state, const std::string& id, bool portable, std::uint32_t samples) {
    const RefinedMesh& mesh = mesh_of(static_cast<int>(state.range(0)));
    render::Framing framing({}, 1.0f);
    for (const Vertex& vertex : mesh.vertices) {
        framing.add({vertex.position[0], vertex.position[1], vertex.position[2]});
    }
    render::Frame frame;
    frame.camera = framing.camera();
    frame.samples = samples;
    const auto rasteriser = portable ? raster::open_portable(backends::open_device(id)) : backends::open_rasteriser(id);
    const auto picture = [&] {
        rasteriser->begin(frame);
        rasteriser->set_materials({{}}, {});
        rasteriser->draw(mesh.vertices, mesh.indices, 0);
        return rasteriser->finish();
    };
    picture();
    for (auto _ : state) {
        benchmark::DoNotOptimize(picture());
    }
    state.counters["triangles"] = static_cast<double>(mesh.indices.size() / 3);
    state.counters["triangles/s"] =
        benchmark::Counter(static_cast<double>(mesh.indices.size() / 3), benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

int main(int argc, char** argv) {
    for (const gpu::DeviceInfo& info : backends::list_devices().devices) {
        const auto add = [&](bool portable, std::uint32_t samples) {
            const std::string name = fmt::format("{}/{}/{}", info.id, portable ? "portable" : "device", samples);
            benchmark::RegisterBenchmark(name.c_str(), draw, info.id, portable, samples)
                ->Arg(4)
                ->Arg(8)
                ->Arg(16)
                ->UseRealTime()
                ->Unit(benchmark::kMillisecond);
        };
        benchmark::AddCustomContext(info.id, info.name);
        add(true, 1);
        add(true, 4);
        if (info.rasteriser) add(false, 4);
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
