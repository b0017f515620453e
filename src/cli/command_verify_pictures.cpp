#include "cli/command_verify_pictures.hpp"

#include "backends/registry.hpp"
#include "cli/look_options.hpp"
#include "cli/progress.hpp"
#include "raster/portable_rasteriser.hpp"
#include "verify/compare_pictures.hpp"
#include "verify/compare_rasterisers.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace tessera::cli {
namespace {

using Json = nlohmann::ordered_json;
using verify::PictureComparison;
using verify::RasteriserComparison;

/// A device that draws by itself.
struct OwnRasteriser {
    gpu::Device device;
    std::unique_ptr<render::Rasteriser> rasteriser;
};

std::vector<OwnRasteriser> open_own_rasterisers(const std::vector<gpu::Device>& devices) {
    std::vector<OwnRasteriser> own;
    for (const gpu::Device& device : devices) {
        if (device.info().rasteriser) own.push_back({device, backends::open_rasteriser(device)});
    }
    return own;
}

/// What one job gave.
struct PictureFindings {
    std::vector<PictureComparison> pictures;
    std::vector<std::pair<gpu::DeviceInfo, RasteriserComparison>> rasterisers;

    bool equal() const {
        return std::ranges::all_of(pictures, [](const PictureComparison& p) { return p.differing == 0; });
    }
};

std::string picture_heading(const gpu::DeviceInfo& info) {
    return info.backend == "reference" ? info.id
                                       : fmt::format("{} {}", info.id, info.name.substr(0, info.name.find(' ')));
}

void print(const std::string& title, const PictureFindings& findings) {
    fmt::print("{}\n", title);
    for (const PictureComparison& picture : findings.pictures) {
        fmt::print("  {:<40.40}{:>10} pixels  {}\n", picture_heading(picture.device), picture.pixels,
                   picture.differing == 0 ? "same bits" : fmt::format("{} differ", picture.differing));
        if (picture.first) fmt::print("    {}\n", verify::describe(*picture.first));
    }
    for (const auto& [device, result] : findings.rasterisers) {
        fmt::print("  {:<40.40}{:>10} pixels  FLIP {:.5f}, {} outliers, {} of them off edges\n",
                   picture_heading(device) + ", its own", result.pixels, result.flip_mean, result.outliers,
                   result.off_edges);
        if (result.first) fmt::print("    {}\n", verify::describe(*result.first));
    }
}

Json to_json(const std::string& input, const JobWords& job, std::uint32_t side, const PictureFindings& findings) {
    Json document{{"input", input},       {"scheme", job.scheme}, {"partitioning", job.partitioning},
                  {"factor", job.factor}, {"width", side},        {"height", side}};
    document["devices"] = Json::array();
    for (const PictureComparison& picture : findings.pictures) {
        Json entry{{"id", picture.device.id},
                   {"name", picture.device.name},
                   {"pixels", picture.pixels},
                   {"differing", picture.differing}};
        if (picture.first) entry["first"] = verify::describe(*picture.first);
        document["devices"].push_back(entry);
    }
    document["rasterisers"] = Json::array();
    for (const auto& [device, result] : findings.rasterisers) {
        Json entry{{"id", device.id},
                   {"name", device.name},
                   {"pixels", result.pixels},
                   {"flip", result.flip_mean},
                   {"over_tolerance", result.over_tolerance},
                   {"outliers", result.outliers},
                   {"off_edges", result.off_edges}};
        if (result.first) entry["first"] = verify::describe(*result.first);
        document["rasterisers"].push_back(entry);
    }
    return document;
}

}  // namespace

int verify_pictures(const Context& context, const PictureWords& words) {
    const std::vector<OwnRasteriser> own = open_own_rasterisers(words.devices);
    verify::PictureDevices painters(words.devices);
    const auto portable = raster::open_portable(words.devices.front());
    Json documents = Json::array();
    std::size_t jobs = 0, different = 0;
    for (const std::string& input : words.inputs) {
        const scene::Scene scene = load(context, input, words.load, true);
        const patches::PatchSet patches = surface_patches(scene);
        const patches::HairSet hair = patches::make_hair(scene, words.hair.width);
        for (const JobWords& job : words.jobs) {
            const verify::PictureSubject subject{scene, patches, hair, resolve(job, patches),
                                                 resolve_hair(words.hair, Ribbons::flat, job.memory_budget)};
            Progress progress("drawing", context.quiet);
            const double steps = 1.0 + static_cast<double>(own.size());
            render::Frame frame;
            LookWords look;
            look.shading = "pbr";
            look.tonemap = "aces";
            apply(look, scene, patches.exponent, frame);
            frame.width = frame.height = words.side;
            frame.camera = verify::fit_camera(words.devices.front(), subject, 1.0f);
            std::vector<render::Frame> frames{frame, frame};
            frames[0].samples = 1;
            PictureFindings findings{painters.compare(subject, frames), {}};
            frame.shading = render::Shading::phong;
            for (const auto& [device, rasteriser] : own) {
                progress.update((1.0 + static_cast<double>(findings.rasterisers.size())) / steps);
                findings.rasterisers.emplace_back(
                    device.info(),
                    verify::compare_rasterisers(words.devices.front(), subject, frame, *rasteriser, *portable));
            }
            ++jobs;
            different += findings.equal() ? 0 : 1;
            if (words.json) {
                documents.push_back(to_json(input, job, words.side, findings));
            } else {
                print(fmt::format("{}: {} patches, {}, {}, factor {}, {} x {} pixels with 1 and 4 samples", input,
                                  patches.patch_count() + hair.patches.size(), job.scheme, job.partitioning, job.factor,
                                  words.side, words.side),
                      findings);
            }
        }
    }
    if (words.json) {
        fmt::print("{}\n", documents.dump(2));
    } else {
        fmt::print("{} jobs on {} devices, {} with differences\n", jobs, words.devices.size(), different);
    }
    return different == 0 ? exit_fine : exit_difference;
}

}  // namespace tessera::cli
