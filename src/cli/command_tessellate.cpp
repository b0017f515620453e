// tessera tessellate: a model in, a refined mesh out.
#include "backends/registry.hpp"
#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/hair_words.hpp"
#include "cli/job_options.hpp"
#include "cli/load.hpp"
#include "cli/progress.hpp"
#include "export/mesh_writer.hpp"
#include "tessellate/scene_tessellator.hpp"

#include <fmt/format.h>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

namespace tessera::cli {
namespace {

struct TessellateWords {
    std::string input, output, device = "reference";
    JobWords job;
    LoadWords load;
    HairWords hair;
    std::string topology = "triangles";
    bool json = false;
};

void report(const Context& context, const TessellateWords& words, const gpu::DeviceInfo& device,
            const patches::PatchSet& patches, const patches::HairSet& hair, SceneTessellator& tessellator,
            double seconds) {
    const MeshTotals& totals = tessellator.totals();
    const StageTimes times = tessellator.times();
    say(context, fmt::format("{}: {} patches -> {} vertices, {} triangles on {} ({})", words.output,
                             patches.patch_count() + hair.patches.size(), totals.vertex_count, totals.index_count / 3,
                             device.id, device.name));
    nlohmann::ordered_json stages = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < stage_count; ++i) {
        const auto stage = static_cast<StageId>(i);
        if (stage == StageId::tangents && !totals.has_tangents) continue;
        if (stage == StageId::attributes && !totals.has_attributes) continue;
        const double milliseconds = times.seconds[i] * 1e3;
        const bool with_vertices = stage == StageId::indices && times.measured && times.seconds[i] == 0.0;
        say(context, !times.measured ? fmt::format("  {:<14}  not timed: the device has no timestamps", name(stage))
                     : with_vertices ? fmt::format("  {:<14}  in the same pass as the vertices", name(stage))
                                     : fmt::format("  {:<14}{:>10.3f} ms", name(stage), milliseconds));
        stages[std::string(name(stage))] = times.measured ? nlohmann::ordered_json(milliseconds) : nullptr;
    }
    say(context, fmt::format("  {:<14}{:>10.3f} ms", "in all", seconds * 1e3));
    if (words.json) {
        const nlohmann::ordered_json document{{"input", words.input},
                                              {"output", words.output},
                                              {"device", device.id},
                                              {"device_name", device.name},
                                              {"scheme", words.job.scheme},
                                              {"normals", words.job.normals},
                                              {"tangents", words.job.tangents},
                                              {"partitioning", words.job.partitioning},
                                              {"factor", words.job.factor},
                                              {"control_vertices", patches.control_vertices.size()},
                                              {"patches", patches.patch_count()},
                                              {"guides", hair.guides.size()},
                                              {"hair_patches", hair.patches.size()},
                                              {"vertices", totals.vertex_count},
                                              {"triangles", totals.index_count / 3},
                                              {"device_bytes", tessellator.device_bytes()},
                                              {"stage_milliseconds", stages},
                                              {"total_milliseconds", seconds * 1e3}};
        fmt::print("{}\n", document.dump(2));
    }
}

int run(const Context& context, const TessellateWords& words) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const scene::Scene scene = load(context, words.input, words.load);
    const patches::PatchSet patches = surface_patches(scene);
    const patches::HairSet hair = patches::make_hair(scene, words.hair.width);
    TessellationOptions options = resolve(words.job, patches);
    options.topology = topology_from_name(words.topology);
    options.time_stages = true;
    HairOptions hair_options = resolve_hair(words.hair, Ribbons::flat, words.job.memory_budget);
    hair_options.time_stages = true;
    if (hair_options.ribbons == Ribbons::camera && words.hair.eye.empty()) {
        throw Error(ErrorKind::usage,
                    "Ribbons of a file cannot face a camera that is not known; say where it is: --eye "
                    "X,Y,Z, in the model's units.");
    }
    gpu::Device device = backends::open_device(words.device);
    SceneTessellator tessellator(device, patches, options, hair, hair_options);
    const auto writer = exporting::create_mesh_writer(words.output, tessellator.totals(), scene);
    if (tessellator.totals().has_colors && std::filesystem::path(words.output).extension() == ".obj") {
        say(context, "An .obj has no place for the colours of vertices: they are left out.");
    }
    {
        Progress progress("tessellating", context.quiet);
        tessellator.run(*writer, Space::model, progress.callback());
    }
    writer->finish();
    report(context, words, device.info(), patches, hair, tessellator,
           std::chrono::duration<double>(Clock::now() - start).count());
    return exit_fine;
}

}  // namespace

void add_tessellate_command(CLI::App& app, Context& context) {
    const auto words = std::make_shared<TessellateWords>();
    CLI::App* command = app.add_subcommand("tessellate", "Refine a model and write it as .glb, .obj or .ply");
    command->footer("Example: tessera tessellate fox.glb -o smooth.glb --scheme pn --factor 8 --device opencl");
    command->add_option("input", words->input, "A .gltf, .glb or .obj file, or a built-in shape such as shape:torus")
        ->required();
    command->add_option("-o,--output", words->output, "The file to write: .glb, .obj or .ply")->required();
    command->add_option("--device", words->device, "reference, vulkan[:index or name] or opencl[:index or name]")
        ->capture_default_str();
    command
        ->add_option("--topology", words->topology,
                     "triangles, or quads: the regular grid inside quad patches stays quads (.obj, .glb)")
        ->capture_default_str();
    command->add_flag("--json", words->json, "Print counts and times as JSON on stdout");
    add_load_options(*command, words->load);
    add_job_options(*command, words->job);
    add_tangents_option(*command, words->job);
    add_hair_options(*command, words->hair, "flat");
    command->callback([&context, words] { context.chosen = [&context, words] { return run(context, *words); }; });
}

}  // namespace tessera::cli
