// tessera render: a model in, a picture or several out.
#include "backends/registry.hpp"
#include "base/error.hpp"
#include "cli/camera_options.hpp"
#include "cli/command.hpp"
#include "cli/hair_words.hpp"
#include "cli/job_options.hpp"
#include "cli/load.hpp"
#include "cli/look_options.hpp"
#include "cli/output_words.hpp"
#include "cli/progress.hpp"
#include "cli/render_cells.hpp"
#include "cli/view_options.hpp"
#include "image/panels.hpp"
#include "raster/portable_rasteriser.hpp"
#include "render/survey.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <memory>
#include <numbers>

namespace tessera::cli {
namespace {

struct Words {
    std::string input, device = "reference";
    OutputWords output;
    JobWords job;
    LoadWords load;
    HairWords hair;
    std::string size = "1024x1024";
    CameraWords camera;
    LookWords look;
    ViewWords view;
    std::string raster = "auto";
    std::uint32_t samples = 4;
    bool transparent = false;
    std::vector<std::string> compare;
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

/// Runs one after the other share a progress line.
class Steps {
public:
    Steps(Progress& progress, std::size_t count) : progress_(progress), count_(static_cast<double>(count)) {}
    void run(SceneTessellator& tessellator, MeshSink& sink) {
        tessellator.run(sink, Space::kernel, [&](double f) { progress_.update((done_ + f) / count_); });
        done_ += 1.0;
    }

private:
    Progress& progress_;
    double count_, done_ = 0.0;
};

/// All cells under one camera, side by side if there are several, over the view's legend.
image::Image draw(views::View& view, std::vector<views::Cell>& cells, const render::Frame& frame,
                  render::Rasteriser& rasteriser, const views::Run& run) {
    // Where a label is long, all take two lines.
    const bool long_labels =
        std::ranges::any_of(cells, [](const views::Cell& cell) { return cell.label.find(',') != std::string::npos; });
    std::vector<image::Panel> panels;
    for (views::Cell& cell : cells) {
        panels.push_back({view.draw(cell, frame, rasteriser, run),
                          fmt::format("{}{}{} triangles", cell.label, long_labels ? "\n" : ", ",
                                      cell.tessellator->totals().index_count / 3)});
    }
    const image::Rgba grey{244, 245, 247, 255};  // the default background
    const image::Rgba paper = frame.background.a > 0.0f ? grey : image::Rgba{};
    image::Image picture = panels.size() == 1 ? std::move(panels.front().picture) : image::beside(panels, paper);
    view.append_legend(picture, {frame.width, frame.height}, paper);
    return picture;
}

struct Chosen {
    std::unique_ptr<render::Rasteriser> rasteriser;
    const char* name;
};

/// The device's own rasteriser where it has one that can draw the frame, the portable one elsewhere, unless told.
Chosen open_rasteriser(const std::string& which, const gpu::Device& device, const render::Frame& frame,
                       const Context& context) {
    const bool has_own = device.info().rasteriser;
    if (which == "device" && !has_own) {
        throw Error(ErrorKind::usage,
                    fmt::format("{} has no rasteriser of its own; choose --raster portable.", device.info().id));
    }
    const bool common = render::is_common(frame);
    if (which == "device" && !common) {
        throw Error(ErrorKind::usage,
                    "--raster device draws --shading phong, normals and wireframe without a preset, and the views "
                    "shaded and normals; leave --raster out for the rest.");
    }
    if (which == "auto" && has_own && !common) {
        say(context, fmt::format("The rasteriser of {} does not draw this shading or view: the portable one does.",
                                 device.info().id));
    }
    if (which == "device" || (which == "auto" && has_own && frame.samples == 4 && common)) {
        return {backends::open_rasteriser(device), "its own rasteriser"};
    }
    return {raster::open_portable(device), "the portable rasteriser"};
}

patches::HairSet hair_to_show(const Context& context, const Words& words, const scene::Scene& scene) {
    if (!leaves_hair_out(words.look.view) || scene.guides.empty()) return patches::make_hair(scene, words.hair.width);
    if (scene.meshes.empty()) {
        throw Error(ErrorKind::usage, fmt::format("{} is hair alone, and --view {} shows surfaces only; choose another "
                                                  "view.",
                                                  words.input, words.look.view));
    }
    say(context, fmt::format("--view {} leaves the hair out.", words.look.view));
    return {};
}

int run(const Context& context, const Words& words) {
    check(words.view, words.look.view);
    render::Frame frame;
    std::tie(frame.width, frame.height) = parse_size(words.size);
    frame.samples = words.samples;
    if (words.transparent) {
        frame.background = glm::vec4(0.0f);
    }
    scene::Scene scene = load(context, words.input, words.load, needs_all_maps(words.look));
    const render::CameraChoice camera = resolve(words.camera, scene);
    // What blends is drawn last, over what is behind it.
    std::stable_partition(scene.meshes.begin(), scene.meshes.end(), [&](const scene::Mesh& mesh) {
        return scene.materials[mesh.material].alpha_mode != scene::AlphaMode::blend;
    });
    const patches::PatchSet patches = surface_patches(scene);
    apply(words.look, scene, patches.exponent, frame);
    const patches::HairSet hair = hair_to_show(context, words, scene);
    const HairOptions hair_options = resolve_hair(words.hair, Ribbons::camera, words.job.memory_budget);
    PictureOutput output = resolve_output(words.output);
    gpu::Device device = backends::open_device(words.device);
    const views::Subject subject{device, scene, patches, hair, hair_options};
    std::vector<views::Cell> cells = make_cells(words.job, words.compare, subject);
    const auto [rasteriser, rasteriser_name] = open_rasteriser(words.raster, device, frame, context);

    const auto view = make_view(words.look.view, words.view, subject);

    const std::uint32_t frames = words.output.count();
    Progress progress("rendering", context.quiet);
    Steps steps(progress, view->runs_before(cells.size()) + cells.size() * (1 + view->runs_per_cell() * frames));
    const views::Run run = [&](SceneTessellator& tessellator, MeshSink& sink) { steps.run(tessellator, sink); };
    view->prepare(cells, run);
    // The surface swells out of its coarse mesh, so cameras are fitted to the output itself: one run to fit, one for
    // each frame. Memory stays within the budget either way.
    render::Survey survey(render::scaled(camera, patches.exponent),
                          static_cast<float>(frame.width) / static_cast<float>(frame.height),
                          words.output.turntable > 0, render::bounds_of(patches.control_vertices));
    for (views::Cell& cell : cells)
        run(*cell.tessellator, survey);
    const bool facing = hair_options.ribbons == Ribbons::camera && words.hair.eye.empty();
    for (std::uint32_t i = 0; i < frames; ++i) {
        frame.camera = survey.camera(2.0 * std::numbers::pi * i / frames);
        frame.depth_range = render::depth_range(frame.camera, render::bounds_of(patches.control_vertices));
        for (views::Cell& cell : cells) {
            if (facing) cell.tessellator->face(frame.camera.eye);
        }
        output.add(draw(*view, cells, frame, *rasteriser, run));
    }
    const std::string written = output.finish();
    progress.clear();
    for (const views::Cell& cell : cells) {
        say(context,
            fmt::format("{}: {}, {} patches -> {} triangles on {} ({}), drawn by {}", written, cell.label,
                        patches.patch_count() + hair.patches.size(), cell.tessellator->totals().index_count / 3,
                        device.info().id, device.info().name, rasteriser_name));
    }
    return exit_fine;
}

}  // namespace

void add_render_command(CLI::App& app, Context& context) {
    const auto words = std::make_shared<Words>();
    CLI::App* command =
        app.add_subcommand("render", "Tessellate a model and draw it into a PNG, a sequence or an animation");
    command->footer("Example: tessera render fox.glb -o fox.png --factor 8 --orbit 40,15 --size 1280x960");
    command->add_option("input", words->input, "A .gltf, .glb or .obj file, or a built-in shape such as shape:torus")
        ->required();
    add_output_options(*command, words->output);
    command
        ->add_option("--device", words->device,
                     "Where to tessellate and draw: reference, vulkan[:index or name] or "
                     "opencl[:index or name]")
        ->capture_default_str();
    command->add_option("--size", words->size, "WIDTHxHEIGHT in pixels, up to 8192x8192; of each scheme with --compare")
        ->capture_default_str();
    add_camera_options(*command, words->camera);
    add_look_options(*command, words->look);
    add_view_options(*command, words->view);
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
    command
        ->add_option("--compare", words->compare,
                     "Schemes side by side under one camera: linear,phong,pn, each with normals of its own if they are "
                     "named: pn:linear,pn:quadratic")
        ->delimiter(',')
        ->expected(1, 16);
    add_load_options(*command, words->load);
    add_job_options(*command, words->job);
    add_hair_options(*command, words->hair, "camera");
    command->callback([&context, words] { context.chosen = [&context, words] { return run(context, *words); }; });
}

}  // namespace tessera::cli
