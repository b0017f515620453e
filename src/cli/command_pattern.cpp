// tessera pattern: shows one domain pattern, or checks a file of golden ones.
#include "backends/registry.hpp"
#include "base/error.hpp"
#include "base/output_file.hpp"
#include "cli/command.hpp"
#include "cli/job_options.hpp"
#include "cli/pattern_files.hpp"
#include "verify/golden.hpp"

#include <fmt/format.h>
#include <filesystem>
#include <memory>

namespace tessera::cli {
namespace {

struct PatternWords {
    std::string factors, domain = "triangle", partitioning = "fractional_odd", winding = "cw", device = "reference",
                         output, check;
};

int check(const PatternWords& words) {
    const std::vector<verify::GoldenCase> cases = verify::read_golden_file(words.check);
    std::vector<std::string> ids{words.device};
    if (words.device == "all") {
        ids.clear();
        for (const gpu::DeviceInfo& info : backends::list_devices().devices) {
            ids.push_back(info.id);
        }
    }
    std::size_t total = 0;
    for (const std::string& id : ids) {
        gpu::Device device = backends::open_device(id);
        const std::vector<verify::GoldenMismatch> mismatches = verify::check_golden_cases(device, cases);
        for (const verify::GoldenMismatch& mismatch : mismatches) {
            fmt::print("{}: {}\n", id, verify::describe(mismatch));
        }
        fmt::print("{} ({}): {} of {} cases match\n", device.info().id, device.info().name,
                   cases.size() - mismatches.size(), cases.size());
        total += mismatches.size();
    }
    fmt::print("{} cases, {} mismatches\n", cases.size() * ids.size(), total);
    return total == 0 ? exit_fine : exit_difference;
}

void draw(const Pattern& pattern, Domain domain, const PatternWords& words) {
    if (domain == Domain::isoline) {
        throw Error(ErrorKind::usage, "Isolines are lines, which the rasteriser does not draw; write a .svg or .csv.");
    }
    const auto rasteriser = backends::open_rasteriser();
    render::Frame frame;
    frame.width = 1024;
    frame.height = 896;
    frame.shading = render::Shading::wireframe;
    const render::Bounds bounds{{0.0f, 0.0f, 0.0f}, {1.0f, domain == Domain::triangle ? 0.8660254f : 1.0f, 0.0f}};
    frame.camera = render::frame_bounds(bounds, {0.0f, 0.0f, 0.3f, 1.0f}, 1024.0f / 896.0f);
    rasteriser->begin(frame);
    scene::Material paper;
    paper.double_sided = true;
    rasteriser->set_materials({paper}, {});
    rasteriser->draw(pattern_vertices(pattern, domain), pattern.indices, 0);
    image::write_png(rasteriser->finish(), words.output);
}

int show(const Context& context, const PatternWords& words) {
    if (words.winding != "cw" && words.winding != "ccw") {
        throw Error(ErrorKind::usage,
                    fmt::format("There is no winding named \"{}\"; choose cw or ccw.", words.winding));
    }
    const Domain domain = domain_from_name(words.domain);
    const std::vector<PatchFactors> factors{factors_from_words(words.factors, domain)};
    gpu::Device device = backends::open_device(words.device);
    const Pattern pattern =
        make_patterns(device, domain, partitioning_from_name(words.partitioning), words.winding == "cw", factors)
            .front();
    const std::string extension = std::filesystem::path(words.output).extension().string();
    if (words.output.empty()) {
        fmt::print("{}", pattern_csv(pattern, domain));
    } else if (extension == ".svg") {
        write_text(words.output, pattern_svg(pattern, domain));
    } else if (extension == ".csv") {
        write_text(words.output, pattern_csv(pattern, domain));
    } else if (extension == ".png") {
        draw(pattern, domain, words);
    } else {
        throw Error(
            ErrorKind::usage,
            fmt::format("{} has an unknown extension; a pattern is written as .svg, .png or .csv.", words.output));
    }
    say(context, domain == Domain::isoline
                     ? fmt::format("{} points, {} segments", pattern.points.size(), pattern.indices.size() / 2)
                     : fmt::format("{} points, {} triangles", pattern.points.size(), pattern.indices.size() / 3));
    return exit_fine;
}

int run(const Context& context, const PatternWords& words) {
    if (words.factors.empty() == words.check.empty()) {
        throw Error(ErrorKind::usage, "Give either --factors to show a pattern or --check to check a file of them.");
    }
    return words.check.empty() ? show(context, words) : check(words);
}

}  // namespace

void add_pattern_command(CLI::App& app, Context& context) {
    const auto words = std::make_shared<PatternWords>();
    CLI::App* command = app.add_subcommand("pattern", "Show one domain pattern, or check a file of golden ones");
    command->footer(
        "Examples: tessera pattern --factors 3,5.5,8,6 -o pattern.svg\n"
        "          tessera pattern --check tessellator.csv --device all");
    command->add_option(
        "--factors", words->factors,
        "F, or all of them: triangle U=0,V=0,W=0,INSIDE; quad U=0,V=0,U=1,V=1,INSIDE_U,INSIDE_V; isoline "
        "DENSITY,DETAIL");
    command->add_option("--domain", words->domain, "triangle, quad or isoline")->capture_default_str();
    command
        ->add_option("--partitioning", words->partitioning, "integer, pow2, fractional_odd, fractional_even or uniform")
        ->capture_default_str();
    command->add_option("--winding", words->winding, "cw or ccw, the words of D3D")->capture_default_str();
    command->add_option("--device", words->device, "Where to compute it; `all` with --check")->capture_default_str();
    command->add_option("-o,--output", words->output, "The file to write: .svg, .png or .csv (default: CSV on stdout)");
    command->add_option("--check", words->check, "Recompute every case of this golden file and compare");
    command->callback([&context, words] { context.chosen = [&context, words] { return run(context, *words); }; });
}

}  // namespace tessera::cli
