// tessera verify: the same job on every device, every stage's buffers compared bit by bit with the reference.
#include "backends/registry.hpp"
#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/command_verify_oracle.hpp"
#include "cli/command_verify_pictures.hpp"
#include "cli/hair_words.hpp"
#include "cli/job_options.hpp"
#include "cli/load.hpp"
#include "cli/progress.hpp"
#include "verify/compare_jobs.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

namespace tessera::cli {
namespace {

using Json = nlohmann::ordered_json;
using verify::DeviceComparison;

struct VerifyWords {
    std::vector<std::string> inputs, devices, required;
    JobWords job;
    LoadWords load;
    HairWords hair;
    bool all = false;
    bool json = false;
    bool markdown = false;
    std::string oracle;
    bool pictures = false;
    std::uint32_t pixels = 256;  // to a side of a picture
};

// The reference first, then what was asked for or everything found. A required backend that is missing fails.
std::vector<gpu::Device> open_devices(const Context& context, const VerifyWords& words) {
    std::vector<std::string> ids = words.devices;
    if (ids.empty()) {
        const backends::Inventory inventory = backends::list_devices();
        for (const gpu::DeviceInfo& info : inventory.devices) {
            ids.push_back(info.id);
        }
        for (const gpu::UnusableDevice& device : inventory.unusable) {
            say(context, fmt::format("{} is left out: {}", device.id, device.reason));
        }
    }
    std::vector<gpu::Device> devices{backends::open_device("reference")};
    for (const std::string& id : ids) {
        gpu::Device device = backends::open_device(id);
        const bool known =
            std::ranges::any_of(devices, [&](const gpu::Device& d) { return d.info().id == device.info().id; });
        if (!known) {
            devices.push_back(std::move(device));
        }
    }
    for (const std::string& backend : words.required) {
        if (std::ranges::none_of(devices, [&](const gpu::Device& d) { return d.info().backend == backend; })) {
            throw Error(
                ErrorKind::device_unavailable,
                fmt::format("The backend {} is required, but none of the devices compared has it; `tessera devices` "
                            "says why.",
                            backend));
        }
    }
    return devices;
}

// A column heading that fits: the id and the first word of the name.
std::string heading(const gpu::DeviceInfo& info) {
    return info.backend == "reference" ? info.id
                                       : fmt::format("{} {}", info.id, info.name.substr(0, info.name.find(' ')));
}

void print(const std::string& title, const std::vector<DeviceComparison>& results) {
    fmt::print("{}\n  {:<14}{:>14}", title, "stage", "words");
    std::vector<std::size_t> widths;
    for (const DeviceComparison& result : results) {
        const std::string head = heading(result.device);
        widths.push_back(std::max<std::size_t>(head.size(), 10));
        fmt::print("  {:>{}}", head, widths.back());
    }
    fmt::print("\n");
    for (std::size_t s = 0; s < stage_count; ++s) {
        fmt::print("  {:<14}{:>14}", name(static_cast<StageId>(s)), results.front().stages[s].words);
        for (std::size_t d = 0; d < results.size(); ++d) {
            const verify::StageComparison& stage = results[d].stages[s];
            const bool compared = stage.words > 0 || s < static_cast<std::size_t>(StageId::vertices);
            fmt::print(
                "  {:>{}}",
                stage.differing == 0 ? (compared ? "same bits" : "-") : fmt::format("{} differ", stage.differing),
                widths[d]);
        }
        fmt::print("\n");
    }
    for (const DeviceComparison& result : results) {
        for (std::size_t s = 0; s < stage_count; ++s) {
            if (result.stages[s].first) {
                fmt::print("  {}, {}: {}\n", heading(result.device), name(static_cast<StageId>(s)),
                           verify::describe(*result.stages[s].first));
            }
        }
    }
}

// `document` tells what was compared.
Json with_results(Json document, const std::vector<DeviceComparison>& results) {
    document["devices"] = Json::array();
    for (const DeviceComparison& result : results) {
        Json stages = Json::object();
        for (std::size_t s = 0; s < stage_count; ++s) {
            const verify::StageComparison& stage = result.stages[s];
            Json entry{{"words", stage.words}, {"differing", stage.differing}};
            if (stage.first) {
                entry["first"] = verify::describe(*stage.first);
            }
            stages[std::string(name(static_cast<StageId>(s)))] = entry;
        }
        document["devices"].push_back({{"id", result.device.id}, {"name", result.device.name}, {"stages", stages}});
    }
    return document;
}

Json to_json(const std::string& input, const TessellationOptions& options, const std::string& factor) {
    return {{"input", input},
            {"scheme", name(options.scheme)},
            {"normals", name(options.normals)},
            {"tangents", name(options.tangents)},
            {"partitioning", name(options.partitioning)},
            {"factor", factor}};
}

Json to_json(const std::string& input, const HairOptions& options) {
    return {{"input", input},
            {"ribbons", name(options.ribbons)},
            {"hairs", options.hairs},
            {"segments", options.segments},
            {"partitioning", name(options.partitioning)}};
}

// Adds the counts of one job's comparison to the sums of all jobs.
void add(std::vector<DeviceComparison>& sums, const std::vector<DeviceComparison>& results) {
    if (sums.empty()) {
        sums = results;
        return;
    }
    for (std::size_t d = 0; d < sums.size(); ++d) {
        for (std::size_t s = 0; s < stage_count; ++s) {
            sums[d].stages[s].words += results[d].stages[s].words;
            sums[d].stages[s].differing += results[d].stages[s].differing;
        }
    }
}

// A table device x stage over all jobs: differing words of words compared.
void print_markdown(const std::vector<DeviceComparison>& sums, std::size_t jobs) {
    fmt::print("| device |");
    for (std::size_t s = 0; s < stage_count; ++s) {
        fmt::print(" {} |", name(static_cast<StageId>(s)));
    }
    fmt::print("\n|---|");
    for (std::size_t s = 0; s < stage_count; ++s)
        fmt::print("---|");
    fmt::print("\n");
    for (std::size_t d = 1; d < sums.size(); ++d) {
        const gpu::DeviceInfo& info = sums[d].device;
        fmt::print("| {} ({}, {}) |", info.backend, info.name, info.driver);
        for (const verify::StageComparison& stage : sums[d].stages) {
            fmt::print(" {} of {} |", stage.differing, stage.words);
        }
        fmt::print("\n");
    }
    fmt::print("\nDiffering of compared 32-bit words, summed over {} jobs, against the {} backend.\n", jobs,
               sums.front().device.id);
}

// What to compare: the options given, or with --all every scheme, kind of normals and partitioning; tangents, where no
// kind of them is asked for, of both kinds once per scheme.
std::vector<JobWords> variants(const VerifyWords& words) {
    if (!words.all) {
        return {words.job};
    }
    std::vector<JobWords> list;
    for (const char* scheme : {"linear", "phong", "pn", "stpn"}) {
        // The oracle has no tags.
        if (!words.oracle.empty() && std::string_view(scheme) == "stpn") continue;
        for (const char* normals : {"linear", "quadratic", "true"}) {
            // Nor true normals.
            if (!words.oracle.empty() && std::string_view(normals) == "true") continue;
            for (const char* partitioning : {"integer", "pow2", "fractional_odd", "fractional_even", "uniform"}) {
                JobWords job = words.job;
                job.scheme = scheme;
                job.normals = normals;
                job.partitioning = partitioning;
                const bool once = words.oracle.empty() && words.job.tangents == "none" &&
                                  std::string_view(partitioning) == "fractional_odd";
                if (once && std::string_view(normals) == "linear") job.tangents = "surface";
                if (once && std::string_view(normals) == "quadratic") job.tangents = "uv";
                list.push_back(job);
            }
        }
    }
    return list;
}

// Likewise for hair: both kinds of ribbons unless one is asked for, and with --all every partitioning along a hair.
// Without
// --eye the camera stands in front of the model's right upper corner.
std::vector<HairOptions> hair_variants(const VerifyWords& words, const patches::HairSet& hair) {
    HairOptions options = resolve_hair(words.hair, Ribbons::flat, words.job.memory_budget);
    if (words.hair.eye.empty()) {
        options.eye = {patches::to_model_space(1.5f, hair.exponent), patches::to_model_space(1.0f, hair.exponent),
                       patches::to_model_space(4.0f, hair.exponent)};
    }
    std::vector<HairOptions> list;
    for (const Ribbons ribbons : {Ribbons::camera, Ribbons::flat}) {
        if (!words.hair.ribbons.empty() && ribbons != options.ribbons) continue;
        for (const Partitioning partitioning :
             {Partitioning::integer, Partitioning::pow2, Partitioning::fractional_odd, Partitioning::fractional_even}) {
            if (partitioning != Partitioning::integer && !words.all) continue;
            list.push_back(options);
            list.back().ribbons = ribbons;
            list.back().partitioning = partitioning;
        }
    }
    return list;
}

// With --all every scheme once: what else tells jobs apart shows in buffers.
std::vector<JobWords> picture_jobs(const VerifyWords& words) {
    if (!words.all) return {words.job};
    std::vector<JobWords> list;
    for (const char* scheme : {"linear", "phong", "pn", "stpn"}) {
        list.push_back(words.job);
        list.back().scheme = scheme;
    }
    return list;
}

// What all comparisons together say.
struct Report {
    const VerifyWords& words;
    Json documents = Json::array();
    std::vector<DeviceComparison> sums;
    std::size_t jobs = 0, different = 0;

    void add_job(const std::string& title, Json document, const std::vector<DeviceComparison>& results) {
        ++jobs;
        different += std::ranges::all_of(results, &DeviceComparison::equal) ? 0 : 1;
        add(sums, results);
        if (words.json) {
            documents.push_back(with_results(std::move(document), results));
        } else if (!words.markdown) {
            print(title, results);
        }
    }

    void finish(std::size_t devices) const {
        if (words.json) {
            fmt::print("{}\n", documents.dump(2));
        } else if (words.markdown) {
            print_markdown(sums, jobs);
        } else {
            fmt::print("{} jobs on {} devices, {} with differences\n", jobs, devices, different);
        }
    }
};

int run(const Context& context, const VerifyWords& words) {
    if (!words.oracle.empty()) {
        const std::vector<std::string> devices =
            words.devices.empty() ? std::vector<std::string>{"reference"} : words.devices;
        return verify_with_oracle(context, {words.inputs, devices, words.load, variants(words), words.all, words.json});
    }
    const std::vector<gpu::Device> devices = open_devices(context, words);
    if (words.pictures) {
        return verify_pictures(
            context, {words.inputs, devices, words.load, words.hair, picture_jobs(words), words.pixels, words.json});
    }
    Report report{words, Json::array(), {}};
    for (const std::string& input : words.inputs) {
        const scene::Scene scene = load(context, input, words.load, true);  // tangents of normal maps are compared too
        const patches::PatchSet patches = surface_patches(scene);
        for (const JobWords& job : variants(words)) {
            if (patches.patch_count() == 0) break;
            const TessellationOptions options = resolve(job, patches);
            Progress progress("comparing", context.quiet);
            const auto results = verify::compare_jobs(devices, patches, options, progress.callback());
            report.add_job(
                fmt::format("{}: {} patches, {}, {} normals, {} tangents, {}, factor {}", input, patches.patch_count(),
                            job.scheme, job.normals, options.tangents == Tangents::none ? "no" : job.tangents,
                            job.partitioning, job.factor),
                to_json(input, options, job.factor), results);
        }
        const patches::HairSet hair = patches::make_hair(scene, words.hair.width);
        if (hair.empty()) continue;
        for (const HairOptions& options : hair_variants(words, hair)) {
            Progress progress("comparing hair", context.quiet);
            const auto results = verify::compare_hair_jobs(devices, hair, options, progress.callback());
            report.add_job(fmt::format("{}: {} guides, {} patches of {} hairs, {} segments, {}, {} ribbons", input,
                                       hair.guides.size(), hair.patches.size(), options.hairs, options.segments,
                                       name(options.partitioning), name(options.ribbons)),
                           to_json(input, options), results);
        }
    }
    report.finish(devices.size());
    return report.different == 0 ? exit_fine : exit_difference;
}

}  // namespace

void add_verify_command(CLI::App& app, Context& context) {
    const auto words = std::make_shared<VerifyWords>();
    CLI::App* command =
        app.add_subcommand("verify", "Run the same job on every device and compare every buffer bit by bit");
    command->footer("Example: tessera verify fox.glb --all --factor random:1..9 --require vulkan,opencl");
    command->add_option("inputs", words->inputs, "Models or built-in shapes")->required();
    command->add_option("--device", words->devices,
                        "A device to hold against the reference; repeat for more (default: all)");
    CLI::Option* required =
        command
            ->add_option("--require", words->required, "Backends that must be among the devices, separated by commas")
            ->delimiter(',');
    command->add_flag("--all", words->all, "Every scheme, kind of normals and partitioning, one after another");
    command->add_flag("--json", words->json, "Print JSON on stdout");
    CLI::Option* markdown =
        command->add_flag("--markdown", words->markdown, "Print one table device x stage over all jobs, for documents");
    command
        ->add_option(
            "--oracle", words->oracle,
            "fixed-function: instead hold the kernels (of --device, default reference) against the tessellation "
            "stage of the first device that has one")
        ->check(CLI::IsMember({"fixed-function"}))
        ->excludes(required, markdown);
    CLI::Option* pictures =
        command
            ->add_flag(
                "--pictures", words->pictures,
                "Instead compare pictures bit by bit: tessellated and drawn on every device by kernels, with the "
                "model's materials, 1 and 4 samples per pixel; and tell how close the devices' own rasterisers "
                "come. With --all every scheme")
            ->excludes(markdown)
            ->excludes("--oracle");
    command->add_option("--pixels", words->pixels, "Width and height of the pictures")
        ->needs(pictures)
        ->check(CLI::Range(1, 4096))
        ->capture_default_str();
    add_load_options(*command, words->load);
    add_job_options(*command, words->job);
    add_tangents_option(*command, words->job)->excludes("--oracle")->excludes(pictures);
    add_hair_options(*command, words->hair, "both, one after the other");
    command->callback([&context, words] { context.chosen = [&context, words] { return run(context, *words); }; });
}

}  // namespace tessera::cli
