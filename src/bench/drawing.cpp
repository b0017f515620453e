#include "bench/drawing.hpp"

#include "bench/growth.hpp"
#include "bench/workload.hpp"
#include "render/resident_mesh.hpp"
#include "scene/scene.hpp"
#include "tessellate/tessellate.hpp"

#include <fmt/format.h>
#include <array>

namespace tessera::bench {
namespace {

constexpr const char* own_prefix = "own of ";

RefinedMesh sphere(const gpu::Device& device, float factor, bool quick) {
    TessellationOptions options;
    options.scheme = Scheme::pn;
    options.partitioning = Partitioning::uniform;
    options.factors = equal_factors(factor);
    const patches::PatchSet set =
        patches::make_patches(scene::load_scene(quick ? "shape:sphere:5" : "shape:sphere:50"));
    return tessellate(device, set, options);
}

render::Camera camera_of(const RefinedMesh& mesh) {
    render::Framing framing({}, 1.0f);
    for (const Vertex& vertex : mesh.vertices) {
        framing.add({vertex.position[0], vertex.position[1], vertex.position[2]});
    }
    return framing.camera();
}

/// Draws one mesh into a picture of its own rasteriser.
class Drawer {
public:
    Drawer(std::string name, std::unique_ptr<render::Rasteriser> rasteriser, const RefinedMesh& mesh,
           const render::Camera& camera, std::uint32_t samples)
        : name_(std::move(name)), rasteriser_(std::move(rasteriser)), mesh_(mesh) {
        frame_.camera = camera;
        frame_.samples = samples;
    }

    /// From now on the mesh lies on this device, where the rasteriser can draw from there.
    void put_on(const gpu::Device& device) {
        rasteriser_->begin(frame_);
        if (rasteriser_->draws_from(device)) resident_ = render::upload_mesh(device, mesh_.vertices, mesh_.indices);
    }

    const std::string& name() const { return name_; }

    void draw() {
        rasteriser_->begin(frame_);
        rasteriser_->set_materials({{}}, {});
        if (resident_.vertices) {
            rasteriser_->draw(resident_);
        } else {
            rasteriser_->draw(mesh_.vertices, mesh_.indices, 0);
        }
        (void)rasteriser_->finish();
    }

private:
    std::string name_;
    std::unique_ptr<render::Rasteriser> rasteriser_;
    const RefinedMesh& mesh_;
    render::Frame frame_;
    render::DeviceDraw resident_;
};

std::vector<Drawer> drawers_of(const std::vector<gpu::Device>& devices, const Rasterisers& rasterisers,
                               const RefinedMesh& mesh) {
    const render::Camera camera = camera_of(mesh);
    std::vector<Drawer> drawers;
    for (const gpu::Device& device : devices) {
        const std::string& id = device.info().id;
        if (rasterisers.portable) {
            for (const std::uint32_t samples : {1u, 4u}) {
                drawers.emplace_back(portable_contestant(id, samples, false), rasterisers.portable(device), mesh,
                                     camera, samples);
                drawers.back().put_on(device);
            }
            drawers.emplace_back(portable_contestant(id, 4, true), rasterisers.portable(device), mesh, camera, 4);
        }
        auto own = rasterisers.own ? rasterisers.own(device) : nullptr;
        if (own != nullptr) {
            drawers.emplace_back(own_contestant(id, false), std::move(own), mesh, camera, 4);
            drawers.back().put_on(device);
            drawers.emplace_back(own_contestant(id, true), rasterisers.own(device), mesh, camera, 4);
        }
    }
    return drawers;
}

struct Timed {
    std::string name;
    Summary seconds;
};

std::vector<Timed> time_drawers(const std::vector<gpu::Device>& devices, const Effort& effort,
                                const Rasterisers& rasterisers, const RefinedMesh& mesh) {
    std::vector<Drawer> drawers = drawers_of(devices, rasterisers, mesh);
    std::vector<Contestant> contestants;
    for (Drawer& drawer : drawers) {
        contestants.push_back({drawer.name(), [&drawer] { drawer.draw(); }});
    }
    Effort enough = effort;
    enough.repetitions = (effort.repetitions + 1) / 2;
    enough.warm_ups = 1;
    interleave(contestants, enough);
    std::vector<Timed> timed;
    for (const Contestant& contestant : contestants) {
        timed.push_back({contestant.name, summarise(contestant.seconds)});
    }
    return timed;
}

Figure figure_of(const Timed& timed, const RefinedMesh& mesh) {
    Figure figure;
    figure.workload = "W7";
    figure.contestant = timed.name;
    figure.peer = timed.name.starts_with(own_prefix);
    figure.seconds = timed.seconds;
    figure.vertices = mesh.vertices.size();
    figure.triangles = mesh.indices.size() / 3;
    return figure;
}

}  // namespace

std::string portable_contestant(const std::string& device, std::uint32_t samples, bool uploaded) {
    return fmt::format("portable on {}, {} sample{}{}", device, samples, samples == 1 ? "" : "s",
                       uploaded ? ", uploaded" : "");
}

std::string own_contestant(const std::string& device, bool uploaded) {
    return fmt::format("{}{}, 4 samples{}", own_prefix, device, uploaded ? ", uploaded" : "");
}

void measure_drawing(Report& report, const std::vector<gpu::Device>& devices, const Effort& effort,
                     const Rasterisers& rasterisers, bool quick) {
    if (devices.empty()) return;
    Table growth{"W7-growth", "drawing, by triangles", growth_note, {"contestant"}, {}};
    std::vector<double> triangles;
    std::vector<std::vector<double>> medians;
    RefinedMesh mesh;
    std::vector<Timed> timed;
    for (const float factor : quick ? std::array{2.0f, 4.0f, 8.0f} : std::array{4.0f, 8.0f, 16.0f}) {
        mesh = sphere(devices.front(), factor, quick);
        timed = time_drawers(devices, effort, rasterisers, mesh);
        triangles.push_back(static_cast<double>(mesh.indices.size() / 3));
        growth.columns.push_back(fmt::format("{:.4g} million, ms", triangles.back() * 1e-6));
        medians.resize(timed.size());
        for (std::size_t i = 0; i < timed.size(); ++i) {
            medians[i].push_back(timed[i].seconds.median);
        }
    }
    report.workloads.emplace_back("W7",
                                  fmt::format("{:.4g} million triangles drawn at 1024 x 1024 and the picture read "
                                              "back; from buffers of the device, or uploaded meanwhile",
                                              triangles.back() * 1e-6));
    add_growth_columns(growth, "triangle");
    for (std::size_t i = 0; i < timed.size(); ++i) {
        report.figures.push_back(figure_of(timed[i], mesh));
        growth.rows.push_back(growth_row(timed[i].name, triangles, medians[i]));
    }
    report.tables.push_back(std::move(growth));
}

}  // namespace tessera::bench
