// Drawing: the portable rasteriser on every device, and the devices' own where they have one, of the same mesh at
// 1024 x 1024: shape:sphere:50 with 16 segments to an edge is 5.12 million triangles.
//
//   build/release/bench_raster --benchmark_filter=opencl --benchmark_repetitions=5
//
// "portable" and "device" (the device's own rasteriser) draw a mesh that lies on the device, "upload" one that lies in
// memory, by the portable one: an iteration draws and reads the picture back. Kernels are compiled before the clock
// starts.
#include "tessera.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <map>

namespace {

using namespace tessera;

enum class How { portable, upload, device };

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

void draw(benchmark::State& state, const std::string& id, How how, std::uint32_t samples) {
    const RefinedMesh& mesh = mesh_of(static_cast<int>(state.range(0)));
    render::Framing framing({}, 1.0f);
    for (const Vertex& vertex : mesh.vertices) {
        framing.add({vertex.position[0], vertex.position[1], vertex.position[2]});
    }
    render::Frame frame;
    frame.camera = framing.camera();
    frame.samples = samples;
    const gpu::Device device = backends::open_device(id);
    const auto rasteriser = how == How::device ? backends::open_rasteriser(device) : raster::open_portable(device);
    const auto resident =
        how != How::upload ? render::upload_mesh(device, mesh.vertices, mesh.indices) : render::DeviceDraw{};
    const auto picture = [&] {
        rasteriser->begin(frame);
        rasteriser->set_materials({{}}, {});
        if (how != How::upload) {
            rasteriser->draw(resident);
        } else {
            rasteriser->draw(mesh.vertices, mesh.indices, 0);
        }
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
        const auto add = [&](const char* name, How how, std::uint32_t samples) {
            const std::string whole_name = fmt::format("{}/{}/{}", info.id, name, samples);
            benchmark::RegisterBenchmark(whole_name.c_str(), draw, info.id, how, samples)
                ->Arg(4)
                ->Arg(8)
                ->Arg(16)
                ->UseRealTime()
                ->Unit(benchmark::kMillisecond);
        };
        benchmark::AddCustomContext(info.id, info.name);
        for (const std::uint32_t samples : {1u, 4u}) {
            add("portable", How::portable, samples);
            add("upload", How::upload, samples);
        }
        if (info.rasteriser) add("device", How::device, 4);
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
