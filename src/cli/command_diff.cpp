// tessera diff: two pictures in, numbers and a verdict out.
#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/load.hpp"
#include "compare/heat_map.hpp"
#include "compare/verdict.hpp"

#include <fmt/format.h>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

namespace tessera::cli {
namespace {

struct DiffWords {
    std::string first, second, output;
    compare::CompareOptions options;
    double max_flip = 0.0;
    std::int64_t max_outliers = 0;
    bool json = false;
};

/// A tolerance is a gate of its own: nothing may lie outside it, unless a number of outliers is allowed.
compare::Gates gates_from(const CLI::App& command, const DiffWords& words) {
    compare::Gates gates;
    if (command.count("--max-flip") > 0) {
        if (!(words.max_flip >= 0.0 && words.max_flip <= 1.0)) {
            throw Error(ErrorKind::usage,
                        fmt::format("The mean of FLIP is in [0, 1]; --max-flip {} is not.", words.max_flip));
        }
        gates.max_flip = words.max_flip;
    }
    if (command.count("--max-outliers") > 0 || command.count("--tolerance") > 0) {
        gates.max_outliers = static_cast<std::uint64_t>(words.max_outliers);
    }
    return gates;
}

nlohmann::ordered_json as_json(const DiffWords& words, const compare::Comparison& c, const compare::Verdict& verdict) {
    const auto& p = c.pixels;
    nlohmann::ordered_json document;
    document["first"] = words.first;
    document["second"] = words.second;
    document["width"] = c.width;
    document["height"] = c.height;
    document["transparent"] = c.transparent;
    document["equal"] = p.equal;
    document["differing_pixels"] = p.differing;
    document["max_difference"] = p.max_difference;
    document["tolerance"] = words.options.tolerance;
    document["over_tolerance"] = p.over_tolerance;
    document["outliers"] = p.outliers;
    // JSON has no infinity.
    document["psnr"] = std::isfinite(c.psnr) ? nlohmann::ordered_json(c.psnr) : nlohmann::ordered_json();
    document["ssim"] = c.ssim;
    document["flip"] = {{"mean", c.flip_mean},
                        {"percentile_99", c.flip_99},
                        {"max", c.flip_max},
                        {"pixels_per_degree", words.options.pixels_per_degree}};
    document["pass"] = verdict.pass;
    document["failures"] = verdict.failures;
    return document;
}

void print(const DiffWords& words, const compare::Comparison& c, const compare::Verdict& verdict) {
    const auto& p = c.pixels;
    if (p.equal) {
        fmt::print("bits      equal, {} x {} pixels\n", c.width, c.height);
    } else {
        fmt::print("bits      {} of {} pixels differ, by up to {}, {}, {}, {} steps of R, G, B, A\n", p.differing,
                   std::uint64_t{c.width} * c.height, p.max_difference[0], p.max_difference[1], p.max_difference[2],
                   p.max_difference[3]);
    }
    fmt::print("tolerance {}: {} pixels over it, {} of them outliers\n", words.options.tolerance, p.over_tolerance,
               p.outliers);
    fmt::print("PSNR      {}\n", std::isfinite(c.psnr) ? fmt::format("{:.2f} dB", c.psnr) : "infinite");
    fmt::print("SSIM      {:.6f}\n", c.ssim);
    fmt::print("FLIP      mean {:.6f}, 99th percentile {:.6f}, largest {:.6f}\n", c.flip_mean, c.flip_99, c.flip_max);
    fmt::print("{}\n", verdict.pass ? "PASS" : "FAIL");
    for (const std::string& failure : verdict.failures)
        fmt::print("{}\n", failure);
}

int run(const Context& context, const compare::Gates& gates, const DiffWords& words) {
    const image::Image first = load_picture(words.first);
    const image::Image second = load_picture(words.second);
    if (first.width != second.width || first.height != second.height) {
        throw Error(ErrorKind::usage,
                    fmt::format("Only pictures of the same size can be compared, but {} has {} x {} pixels and {} has "
                                "{} x {}.",
                                words.first, first.width, first.height, words.second, second.width, second.height));
    }
    const compare::Comparison comparison = compare::compare(first, second, words.options);
    const compare::Verdict verdict = compare::judge(comparison, gates);
    if (!words.output.empty()) {
        image::write_png(compare::heat_map(comparison.flip, comparison.width, comparison.height), words.output);
        say(context, fmt::format("{}: FLIP, from black for 0 to light yellow for 1", words.output));
    }
    if (words.json) {
        fmt::print("{}\n",
                   as_json(words, comparison, verdict).dump(2, ' ', true, nlohmann::json::error_handler_t::replace));
    } else {
        print(words, comparison, verdict);
    }
    return verdict.pass ? exit_fine : exit_difference;
}

}  // namespace

void add_diff_command(CLI::App& app, Context& context) {
    const auto words = std::make_shared<DiffWords>();
    CLI::App* command = app.add_subcommand("diff", "Compare two pictures: bits, PSNR, SSIM, FLIP, outliers");
    command->footer(
        "PASS or FAIL: without a gate the bits must be equal; --max-flip, --max-outliers and --tolerance are gates.\n"
        "Transparent pictures are compared over black and over white, and the worse counts; outliers are counted in "
        "the stored channels, alpha among them.\n"
        "Example: tessera diff before.png after.png -o where.png --max-flip 0.01 --tolerance 8 --max-outliers 20");
    command->add_option("first", words->first, "A PNG or JPEG")->required();
    command->add_option("second", words->second, "Another of the same size")->required();
    command->add_option("-o,--output", words->output, "A PNG to write: the FLIP error of every pixel as a heat map");
    command->add_option("--max-flip", words->max_flip, "FAIL where the mean of FLIP is above this, 0 to 1");
    command
        ->add_option("--tolerance", words->options.tolerance,
                     "Of a channel in 8-bit steps; a pixel outside it is an outlier unless the other picture has such "
                     "values within a pixel around")
        ->check(CLI::Range(0, 255))
        ->capture_default_str();
    command->add_option("--max-outliers", words->max_outliers, "FAIL where more pixels than this are outliers")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    command
        ->add_option("--ppd", words->options.pixels_per_degree,
                     "Pixels per degree of sight for FLIP; the default is a 0.7 m wide screen of 3840 pixels at 0.7 m")
        ->check(CLI::Range(1.0, 1000.0))
        ->capture_default_str();
    command->add_flag("--json", words->json, "Print JSON; a PSNR of null is infinite");
    command->callback([&context, command, words] {
        const compare::Gates gates = gates_from(*command, *words);
        context.chosen = [&context, gates, words] { return run(context, gates, *words); };
    });
}

}  // namespace tessera::cli
