// tessera render: a model in, a picture out.
#include "backends/registry.hpp"
#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/job_options.hpp"
#include "cli/load.hpp"
#include "cli/progress.hpp"
#include "raster/portable_rasteriser.hpp"
#include "render/mesh_sinks.hpp"
#include "tessellate/tessellate.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <glm/trigonometric.hpp>
#include <memory>

namespace tessera::cli {
namespace {

struct Words {
    std::string input, output, device = "reference";
    JobWords job;
    LoadWords load;
    std::string size = "1024x1024";
    std::vector<double> camera;
    std::string shading = "phong";
    std::string raster = "auto";
    std::uint32_t samples = 4;
    bool transparent = false;
};

std::pair<std::uint32_t, std::uint32_t> parse_size(const std::string& words) {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    const char* const end = words.data() + words.size();
    const auto first = std::from_chars(words.data(), end, width);
    if (first.ec == std::errc() && first.ptr != end && *first.ptr == 'x') {
        const auto second = std::from_chars(first.ptr + 1, end, height);
        if (second.ec == std::errc() && second.ptr == end && width >= 1 && width <= 8192 && height >= 1 &&
            height <= 8192) {
            return {width, height};
        }
    }
    throw Error(ErrorKind::usage,
                fmt::format("The size \"{}\" is not understood; write WIDTHxHEIGHT with both from 1 to "
                            "8192, such as 1024x768.",
                            words));
}

render::View parse_view(const std::vector<double>& camera) {
    render::View view;
    if (!camera.empty()) view.azimuth = static_cast<float>(glm::radians(camera[0]));
    if (camera.size() > 1) view.elevation = static_cast<float>(glm::radians(camera[1]));
    if (camera.size() > 2) view.distance = static_cast<float>(camera[2]);
    if (camera.size() > 3) view.field_of_view = static_cast<float>(glm::radians(camera[3]));
    if (!(view.distance > 0.0f) || !(view.field_of_view > 0.0f) || !(view.field_of_view < 3.0f)) {
        throw Error(ErrorKind::usage,
                    "The camera needs a distance above 0 and a field of view from 1 to 170 degrees; write "
                    "AZIMUTH,ELEVATION[,DISTANCE[,FIELD_OF_VIEW]].");
    }
    return view;
}

render::Shading parse_shading(const std::string& name) {
    if (name == "phong") return render::Shading::phong;
    if (name == "normals") return render::Shading::normals;
    if (name == "wireframe") return render::Shading::wireframe;
    throw Error(ErrorKind::usage,
                fmt::format("There is no shading named \"{}\"; choose phong, normals or wireframe.", name));
}

/// The device's own rasteriser where it has one that can draw the frame, the portable one elsewhere, unless told.
std::unique_ptr<render::Rasteriser> open_rasteriser(const std::string& which, const gpu::Device& device,
                                                    std::uint32_t samples) {
    const bool has_own = device.info().rasteriser;
    if (which == "device" && !has_own) {
        throw Error(ErrorKind::usage,
                    fmt::format("{} has no rasteriser of its own; choose --raster portable.", device.info().id));
    }
    if (which == "device" || (which == "auto" && has_own && samples == 4)) {
        return backends::open_rasteriser(device.info().id);
    }
    return raster::open_portable(device);
}

int run(const Context& context, const Words& words) {
    render::Frame frame;
    std::tie(frame.width, frame.height) = parse_size(words.size);
    frame.shading = parse_shading(words.shading);
    frame.samples = words.samples;
    if (words.transparent) {
        frame.background = glm::vec4(0.0f);
    }
    const render::View view = parse_view(words.camera);
    scene::Scene scene = load(context, words.input, words.load);
    // What blends is drawn last, over what is behind it.
    std::stable_partition(scene.meshes.begin(), scene.meshes.end(), [&](const scene::Mesh& mesh) {
        return scene.materials[mesh.material].alpha_mode != scene::AlphaMode::blend;
    });
    const patches::PatchSet patches = patches::make_patches(scene);
    const TessellationOptions options = resolve(words.job, patches);
    gpu::Device device = backends::open_device(words.device);
    const auto rasteriser = open_rasteriser(words.raster, device, words.samples);

    Tessellator tessellator(device, patches, options);
    Progress progress("rendering", context.quiet);
    // The surface swells out of its coarse mesh, so the frame is fitted to the output itself: one run to fit, one to
    // draw. Memory stays within the budget either way.
    render::FramingSink framing(view, static_cast<float>(frame.width) / static_cast<float>(frame.height));
    tessellator.run(framing, Space::kernel, [&](double f) { progress.update(0.3 * f); });
    frame.camera = framing.camera();
    rasteriser->begin(frame);
    rasteriser->set_materials(scene.materials, scene.images);
    render::DrawSink draw(*rasteriser, tessellator.totals().parts);
    tessellator.run(draw, Space::kernel, [&](double f) { progress.update(0.3 + 0.7 * f); });
    image::write_png(rasteriser->finish(), words.output);
    say(context, fmt::format("{}: {} patches -> {} triangles on {} ({})", words.output, patches.patch_count(),
                             tessellator.totals().index_count / 3, device.info().id, device.info().name));
    return exit_fine;
}

}  // namespace

void add_render_command(CLI::App& app, Context& context) {
    const auto words = std::make_shared<Words>();
    CLI::App* command = app.add_subcommand("render", "Tessellate a model and draw it into a PNG");
    command->footer("Example: tessera render fox.glb -o fox.png --factor 8 --camera 40,15 --size 1280x960");
    command->add_option("input", words->input, "A .gltf, .glb or .obj file, or a built-in shape such as shape:torus")
        ->required();
    command->add_option("-o,--output", words->output, "The PNG to write")->required();
    command
        ->add_option("--device", words->device,
                     "Where to tessellate and draw: reference, vulkan[:index or name] or "
                     "opencl[:index or name]")
        ->capture_default_str();
    command->add_option("--size", words->size, "WIDTHxHEIGHT in pixels, up to 8192x8192")->capture_default_str();
    command
        ->add_option("--camera", words->camera,
                     "AZIMUTH,ELEVATION[,DISTANCE[,FIELD_OF_VIEW]]: degrees around the model and "
                     "above it, distance in units of the one that just fits")
        ->delimiter(',')
        ->expected(1, 4);
    command->add_option("--shading", words->shading, "phong, normals or wireframe")->capture_default_str();
    command
        ->add_option("--raster", words->raster,
                     "What draws: device (the GPU's own rasteriser), portable (kernels, the same bits on every device) "
                     "or auto: device where there is one")
        ->check(CLI::IsMember({"auto", "device", "portable"}))
        ->capture_default_str();
    command->add_option("--samples", words->samples, "Samples per pixel: 4, or 1, which only portable draws")
        ->check(CLI::IsMember({1, 4}))
        ->capture_default_str();
    command->add_flag("--transparent", words->transparent, "Leave the background transparent");
    add_load_options(*command, words->load);
    add_job_options(*command, words->job);
    command->callback([&context, words] { context.chosen = [&context, words] { return run(context, *words); }; });
}

}  // namespace tessera::cli
