// tessera bench: how fast every device is, beside the roof of memory and the peers.
#include "backends/registry.hpp"
#include "base/error.hpp"
#include "base/output_file.hpp"
#include "bench/fixed_function_peer.hpp"
#include "bench/peers/peers.hpp"
#include "bench/plot.hpp"
#include "bench/run_bench.hpp"
#include "bench/serial_kernel.hpp"
#include "cli/command.hpp"
#include "raster/portable_rasteriser.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

namespace tessera::cli {
namespace {

struct BenchWords {
    std::vector<std::string> workloads, devices;
    std::string json, markdown, plot, remarks;
    int repetitions = 0;
    bool quick = false;
};

std::vector<gpu::Device> open_devices(const Context& context, const std::vector<std::string>& asked) {
    std::vector<gpu::Device> devices;
    if (!asked.empty()) {
        for (const std::string& id : asked) {
            devices.push_back(backends::open_device(id));
        }
        return devices;
    }
    const backends::Inventory inventory = backends::list_devices();
    for (const gpu::DeviceInfo& info : inventory.devices) {
        devices.push_back(backends::open_device(info.id));
    }
    for (const gpu::UnusableDevice& device : inventory.unusable) {
        say(context, fmt::format("{} is left out: {}", device.id, device.reason));
    }
    return devices;
}

std::filesystem::path models_folder() {
    const char* shared = std::getenv("TESSERA_SHARED");
    const std::filesystem::path folder = std::filesystem::path(shared == nullptr ? "../shared" : shared) / "models";
    std::error_code ignored;
    return std::filesystem::is_directory(folder, ignored) ? folder : std::filesystem::path();
}

void check_plot(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    if (!path.empty() && extension != ".svg" && extension != ".png") {
        throw Error(ErrorKind::usage,
                    fmt::format("{} has an unknown extension; a plot is written as .svg or .png.", path));
    }
}

void write_plot(const bench::Report& report, const std::string& path) {
    if (path.empty()) return;
    if (std::filesystem::path(path).extension() == ".svg") {
        write_text(path, bench::plot_svg(report));
    } else {
        image::write_png(bench::plot_image(report), path);
    }
}

// The prose of the document, which no machine can write: what was tried, and what bounds the figures.
std::string read_remarks(const std::string& path) {
    if (path.empty()) return {};
    std::ifstream file(path);
    std::string text((std::istreambuf_iterator<char>(file)), {});
    if (!file) throw Error(ErrorKind::usage, fmt::format("{} cannot be read.", path));
    return text;
}

int run(const Context& context, const BenchWords& words) {
    check_plot(words.plot);
    const std::string remarks = read_remarks(words.remarks);
    bench::Settings settings;
    if (!words.workloads.empty()) settings.workloads = words.workloads;
    settings.source = {models_folder(), words.quick};
    if (words.quick) settings.effort = {3, 1, 1.0};
    if (words.repetitions > 0) settings.effort.repetitions = words.repetitions;
    settings.devices = open_devices(context, words.devices);
    settings.peers = peers::host_peers();
    for (const gpu::Device& device : settings.devices) {
        settings.peers.push_back(bench::serial_kernel_peer(device));
        if (device.info().tessellation_stage) {
            std::ranges::move(bench::fixed_function_peers(backends::open_timed_stage(device.info().id)),
                              std::back_inserter(settings.peers));
        }
    }
    settings.rasterisers.own = [](const gpu::Device& device) {
        return device.info().rasteriser ? backends::open_rasteriser(device) : nullptr;
    };
    settings.rasterisers.portable = [](const gpu::Device& device) { return raster::open_portable(device); };
    settings.missing = peers::peers_not_built();
    const bench::Report report = bench::run_bench(settings, [&](const std::string& line) { say(context, line); });
    fmt::print("{}", bench::to_text(report));
    if (!words.json.empty()) write_text(words.json, bench::to_json(report).dump(2) + "\n");
    if (!words.markdown.empty()) write_text(words.markdown, bench::to_markdown(report, remarks));
    write_plot(report, words.plot);
    for (const bench::Figure& figure : report.figures) {
        if (figure.unsound) return exit_difference;
    }
    return exit_fine;
}

}  // namespace

void add_bench_command(CLI::App& app, Context& context) {
    const auto words = std::make_shared<BenchWords>();
    CLI::App* command = app.add_subcommand("bench", "Measure every device beside the roof of memory and the peers");
    command->footer("Example: tessera bench --workload W1,W2 --json figures.json");
    command
        ->add_option("--workload", words->workloads,
                     "W1 (20,000 patches at factor 16), W2 (random factors), W3 (a large model), W4 (quads), W5 (many "
                     "copies), W6 (growth), W7 (drawing), separated by commas (default: all)")
        ->delimiter(',')
        ->check(CLI::IsMember({"W1", "W2", "W3", "W4", "W5", "W6", "W7"}));
    command->add_option("--device", words->devices, "A device to measure; repeat for more (default: all)");
    command->add_option("--repetitions", words->repetitions, "Rounds at most (default: 15)")
        ->check(CLI::Range(1, 1000));
    command->add_flag("--quick", words->quick, "Small workloads, a few seconds: shows that it works, not how fast");
    command->add_option("--json", words->json, "Write everything to this file as JSON");
    command->add_option("--markdown", words->markdown, "Write a document to this file");
    command->add_option("--remarks", words->remarks, "Markdown that the document has under its table of marks");
    command->add_option("--plot", words->plot, "Draw bars of the rates into this file, .svg or .png");
    command->callback([&context, words] { context.chosen = [&context, words] { return run(context, *words); }; });
}

}  // namespace tessera::cli
