#include "bench/copies.hpp"

#include "base/error.hpp"
#include "bench/job_run.hpp"
#include "render/mesh_sinks.hpp"
#include "render/survey.hpp"
#include "scene/scene.hpp"
#include "tessellate/tessellate.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace tessera::bench {
namespace {

constexpr float factor = 4.0f;
constexpr std::uint64_t triangles_per_patch = 24;  // integer partitioning
constexpr std::uint64_t budget_of_a_batch = 512ull << 20;
/// Without hardware, drivers' own rasterisers and the portable one draw scenes up to these sizes only: more takes
/// minutes and says nothing new.
constexpr double most_drawn_by_own = 1.5e6;
constexpr double most_drawn_by_portable = 4e6;
constexpr double most_drawn_quickly = 5e4;

struct Model {
    const char* id;
    const char* title;
    const char* path;
    std::vector<double> millions;  // of triangles, the rows of the paper
};

// A square of copies side by side, each where the one before ends.
scene::Scene crowd(const std::string& path, std::uint64_t copies) {
    scene::Scene scene = scene::load_scene(path);
    render::Bounds bounds;
    for (const scene::Mesh& mesh : scene.meshes) {
        for (const glm::vec3& p : mesh.positions) {
            bounds.min = glm::min(bounds.min, p);
            bounds.max = glm::max(bounds.max, p);
        }
    }
    const glm::vec3 size = bounds.max - bounds.min;
    const std::vector<scene::Mesh> one = scene.meshes;
    const auto side = static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(copies))));
    scene.meshes.clear();
    for (std::uint64_t i = 0; i < copies; ++i) {
        const glm::vec3 offset(static_cast<float>(i % side) * size.x, 0.0f, static_cast<float>(i / side) * size.z);
        for (scene::Mesh mesh : one) {
            for (glm::vec3& p : mesh.positions) {
                p += offset;
            }
            scene.meshes.push_back(std::move(mesh));
        }
    }
    return scene;
}

TessellationOptions options_of(Scheme scheme) {
    TessellationOptions options;
    options.scheme = scheme;
    options.normals = scheme == Scheme::pn ? Normals::quadratic : Normals::linear;
    options.partitioning = Partitioning::integer;
    options.factors = equal_factors(factor);
    options.memory_budget = budget_of_a_batch;
    return options;
}

double median_of(const Contestant& contestant) {
    return summarise(contestant.seconds).median;
}

Cell rate_cell(double seconds) {
    return seconds > 0.0 ? Cell(1.0 / seconds) : Cell(std::string("-"));
}

Cell gain_cell(double phong, double pn) {
    return phong > 0.0 && pn > 0.0 ? Cell(100.0 * (pn / phong - 1.0)) : Cell(std::string("-"));
}

// One device's two schemes over one crowd, tessellation alone or with drawing.
class Pair {
public:
    Pair(const gpu::Device& device, const Workload& phong, const Workload& pn)
        : device_(device), workloads_{&phong, &pn} {}

    void add_jobs(std::vector<Contestant>& contestants) {
        for (const Workload* workload : workloads_) {
            jobs_.push_back(std::make_unique<JobRun>(device_, *workload));
            contestants.push_back({device_.info().id, [job = jobs_.back().get()] { job->run(); }});
        }
    }

    void add_draws(std::vector<Contestant>& contestants, render::Rasteriser& rasteriser, const scene::Scene& scene) {
        for (const Workload* workload : workloads_) {
            tessellators_.push_back(std::make_unique<Tessellator>(device_, workload->patches, workload->options));
            contestants.push_back({device_.info().id, [t = tessellators_.back().get(), workload, &rasteriser, &scene] {
                                       draw(*t, *workload, rasteriser, scene);
                                   }});
        }
    }

private:
    static void draw(Tessellator& tessellator, const Workload& workload, render::Rasteriser& rasteriser,
                     const scene::Scene& scene) {
        render::Frame frame;
        frame.camera = render::frame_bounds(render::bounds_of(workload.patches.control_vertices), {}, 1.0f);
        rasteriser.begin(frame);
        rasteriser.set_materials(scene.materials, scene.images);
        render::DrawSink sink(rasteriser, tessellator.totals().parts);
        tessellator.run(sink, Space::kernel);
        (void)rasteriser.finish();
    }

    gpu::Device device_;
    std::array<const Workload*, 2> workloads_;
    std::vector<std::unique_ptr<JobRun>> jobs_;
    std::vector<std::unique_ptr<Tessellator>> tessellators_;
};

class CopiesRun {
public:
    CopiesRun(const std::vector<gpu::Device>& devices, const Effort& effort, const Rasterisers& rasterisers, bool quick)
        : devices_(devices), effort_(effort) {
        for (const gpu::Device& device : devices) {
            auto own = rasterisers.own ? rasterisers.own(device) : nullptr;
            const double most = own != nullptr ? most_drawn_by_own : most_drawn_by_portable;
            most_drawn_.push_back(quick ? most_drawn_quickly : device.info().software ? most : 1e12);
            if (own == nullptr && rasterisers.portable) own = rasterisers.portable(device);
            rasterisers_.push_back(std::move(own));
        }
    }

    void add_row(Table& table, const std::string& path, double millions) {
        const std::uint64_t one = patches::make_patches(scene::load_scene(path)).patch_count();
        const double per_copy = static_cast<double>(one * triangles_per_patch);
        const auto copies = std::max<std::uint64_t>(static_cast<std::uint64_t>(millions * 1e6 / per_copy + 0.5), 1);
        const scene::Scene scene = crowd(path, copies);
        const Workload phong{"W5", "", patches::make_patches(scene), options_of(Scheme::phong), factor};
        const Workload pn{"W5", "", phong.patches, options_of(Scheme::pn), factor};
        const double triangles = static_cast<double>(copies) * per_copy;
        std::vector<double> alone = measure(phong, pn, nullptr);
        std::vector<double> drawn = measure(phong, pn, &scene, triangles);
        for (std::size_t d = 0; d < devices_.size(); ++d) {
            const double a = alone[2 * d], b = alone[2 * d + 1], c = drawn[2 * d], e = drawn[2 * d + 1];
            table.rows.push_back({devices_[d].info().id, triangles * 1e-6, static_cast<double>(copies), rate_cell(a),
                                  rate_cell(b), gain_cell(a, b), rate_cell(c), rate_cell(e), gain_cell(c, e)});
        }
    }

private:
    // Median seconds per device: Phong, PN, ... Zero where a device does not draw.
    std::vector<double> measure(const Workload& phong, const Workload& pn, const scene::Scene* drawn,
                                double triangles = 0.0) {
        std::vector<std::unique_ptr<Pair>> pairs;
        std::vector<Contestant> contestants;
        std::vector<std::size_t> places;
        for (std::size_t d = 0; d < devices_.size(); ++d) {
            render::Rasteriser* rasteriser = rasterisers_[d].get();
            if (drawn != nullptr && (rasteriser == nullptr || triangles > most_drawn_[d])) {
                continue;
            }
            pairs.push_back(std::make_unique<Pair>(devices_[d], phong, pn));
            if (drawn == nullptr) pairs.back()->add_jobs(contestants);
            if (drawn != nullptr) pairs.back()->add_draws(contestants, *rasteriser, *drawn);
            places.push_back(d);
        }
        Effort effort = effort_;
        effort.repetitions = (effort.repetitions + 2) / 3;
        effort.warm_ups = 1;
        effort.seconds_each = std::min(effort.seconds_each, 1.0);
        interleave(contestants, effort);
        std::vector<double> medians(2 * devices_.size(), 0.0);
        for (std::size_t i = 0; i < places.size(); ++i) {
            medians[2 * places[i]] = median_of(contestants[2 * i]);
            medians[2 * places[i] + 1] = median_of(contestants[2 * i + 1]);
        }
        return medians;
    }

    const std::vector<gpu::Device>& devices_;
    Effort effort_;
    std::vector<double> most_drawn_;  // triangles
    std::vector<std::unique_ptr<render::Rasteriser>> rasterisers_;
};

}  // namespace

std::vector<Table> measure_copies(const std::vector<gpu::Device>& devices, const WorkloadSource& source,
                                  const Effort& effort, const Rasterisers& rasterisers) {
    if (source.models.empty()) {
        throw Error(ErrorKind::usage,
                    "The models Fox and RiggedFigure are not here; set TESSERA_SHARED to the folder that holds "
                    "models/Fox/Fox.glb.");
    }
    const std::vector<Model> models{
        {"W5-person",
         "copies of RiggedFigure (Nunes et al. 2011, tables 1 and 2)",
         "RiggedFigure/RiggedFigure.glb",
         {0.103, 0.616, 1.33, 2.46, 3.80, 5.54, 7.49, 9.85, 12.40, 15.40, 18.60}},
        {"W5-animal",
         "copies of Fox (Nunes et al. 2011, tables 3 and 4)",
         "Fox/Fox.glb",
         {0.036, 0.47, 0.87, 1.30, 2.00, 2.60, 3.50, 4.40, 5.40, 6.50, 7.80, 9.1, 11.0, 12.0, 14.0, 16.0}}};
    CopiesRun run(devices, effort, rasterisers, source.quick);
    std::vector<Table> tables;
    for (const Model& model : models) {
        Table table{
            model.id,
            model.title,
            "Frames per second of whole jobs at factor 4, and Phong's gain over PN in percent; drawn: rasterised "
            "at 1024 x 1024 as well where the mesh lies, by the device's own rasteriser where it has one (without "
            "hardware up to 1.5 million triangles), else by the portable one (up to 4 million).",
            {"device", "million triangles", "copies", "Phong", "PN", "gain %", "Phong drawn", "PN drawn",
             "gain % drawn"},
            {}};
        for (const double& millions : model.millions) {
            if (source.quick && &millions != &model.millions.front()) break;
            run.add_row(table, (source.models / model.path).string(), millions);
        }
        tables.push_back(std::move(table));
    }
    return tables;
}

}  // namespace tessera::bench
