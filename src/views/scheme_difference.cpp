#include "views/scheme_difference.hpp"

#include "base/error.hpp"
#include "views/colour_bar.hpp"
#include "views/paint.hpp"
#include "views/patch_sink.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

namespace tessera::views {
namespace {

constexpr double rounding = 1e-4;  // per cent: a millionth of the diagonal

using Place = std::array<float, 3>;

class PlaceSink final : public MeshSink {
public:
    explicit PlaceSink(std::vector<Place>& places) : places_(places) {}
    void append(const MeshBatch& batch) override {
        for (const Vertex& vertex : batch.vertices)
            places_.push_back({vertex.position[0], vertex.position[1], vertex.position[2]});
    }

private:
    std::vector<Place>& places_;
};

class DistanceSink final : public MeshSink {
public:
    DistanceSink(const std::vector<Place>& places, std::vector<float>& distances)
        : places_(places), distances_(distances) {}
    void append(const MeshBatch& batch) override {
        for (const Vertex& vertex : batch.vertices) {
            const Place& other = places_.at(distances_.size());
            double squared = 0.0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double apart = double{vertex.position[axis]} - other[axis];
                squared += apart * apart;
            }
            distances_.push_back(static_cast<float>(std::sqrt(squared)));
        }
    }

private:
    const std::vector<Place>& places_;
    std::vector<float>& distances_;
};

class DifferenceSink final : public PatchSink {
public:
    DifferenceSink(Painter& painter, const Scale& scale, double unit, const std::vector<float>& distances,
                   const Subject& subject, const Cell& cell)
        : PatchSink(subject.patches, cell.options, cell.tessellator->totals()),
          painter_(painter),
          scale_(scale),
          unit_(unit),
          distances_(distances) {}

private:
    void take(const PatchOutput& output) override {
        paint(output.material, output.first_vertex, output.vertices, output.indices);
    }
    void take_hair(std::uint32_t material, std::uint64_t first_vertex, std::span<const Vertex> vertices,
                   std::span<const std::uint32_t> indices) override {
        paint(material, first_vertex, vertices, indices);
    }
    void paint(std::uint32_t material, std::uint64_t first_vertex, std::span<const Vertex> vertices,
               std::span<const std::uint32_t> indices) {
        vertices_.assign(vertices.begin(), vertices.end());
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const bool surface = first_vertex + i < distances_.size();
            set_place(vertices_[i], scale_.place(surface ? double{distances_[first_vertex + i]} * unit_ : 0.0));
        }
        painter_.add(material, vertices_, indices);
    }

    Painter& painter_;
    Scale scale_;
    double unit_;
    const std::vector<float>& distances_;
    std::vector<Vertex> vertices_;
};

class DifferenceView final : public View {
public:
    DifferenceView(const Subject& subject, Scheme against, std::string name, const std::optional<Scale>& fixed)
        : subject_(subject),
          against_(against),
          name_(std::move(name)),
          palette_(make_palette(subject.scene.materials)),
          unit_(100.0 / patch_diagonal(subject.patches)),
          fixed_(fixed.has_value()),
          scale_(fixed.value_or(Scale{0.0, 0.0})) {}

    std::size_t runs_before(std::size_t cells) const override { return 2 * cells; }

    void prepare(std::span<Cell> cells, const Run& run) override {
        const patches::HairSet bald;
        for (Cell& cell : cells) {
            TessellationOptions options = cell.options;
            SceneTessellator own(subject_.device, subject_.patches, options, bald, subject_.hair_options);
            options.scheme = against_;
            SceneTessellator other(subject_.device, subject_.patches, options, bald, subject_.hair_options);
            distances_.push_back({&cell, scheme_distances(own, other, run)});
            if (fixed_) continue;
            for (const float distance : distances_.back().second)
                scale_.greatest = std::max(scale_.greatest, double{distance} * unit_);
        }
        if (!fixed_ && scale_.greatest < rounding) scale_.greatest = 1.0;
    }

    image::Image draw(Cell& cell, const render::Frame& frame, render::Rasteriser& rasteriser, const Run& run) override {
        const auto found = std::ranges::find(distances_, &cell, &Distances::first);
        rasteriser.begin(frame);
        rasteriser.set_materials(palette_.materials, palette_.images);
        Painter painter(rasteriser, frame);
        DifferenceSink sink(painter, scale_, unit_, found->second, subject_, cell);
        run(*cell.tessellator, sink);
        painter.flush();
        return rasteriser.finish();
    }

    void append_legend(image::Image& picture, const PanelSize& panel, const image::Rgba& paper) const override {
        append_colour_bar(picture, panel, scale_, fmt::format("distance to {}, % of the diagonal", name_), paper);
    }

private:
    using Distances = std::pair<const Cell*, std::vector<float>>;

    const Subject subject_;
    Scheme against_;
    std::string name_;
    Palette palette_;
    double unit_;
    bool fixed_;
    Scale scale_;
    std::vector<Distances> distances_;
};

}  // namespace

double patch_diagonal(const patches::PatchSet& patches) {
    glm::dvec3 least(1e300), greatest(-1e300);
    for (const patches::PatchCorners& corners : patches.corners) {
        for (const std::uint32_t corner : corners) {
            if (corner == patches::no_corner) continue;
            const float* const p = patches.control_vertices[corner].position;
            least = glm::min(least, glm::dvec3(p[0], p[1], p[2]));
            greatest = glm::max(greatest, glm::dvec3(p[0], p[1], p[2]));
        }
    }
    const double diagonal = patches.corners.empty() ? 0.0 : glm::length(greatest - least);
    return diagonal > 0.0 ? diagonal : 1.0;
}

std::vector<float> scheme_distances(SceneTessellator& a, SceneTessellator& b, const Run& run) {
    if (a.totals().vertex_count != b.totals().vertex_count) {
        throw Error(
            ErrorKind::usage,
            fmt::format("Surfaces of {} and {} vertices have no common domain points; compare schemes with equal "
                        "factors and partitioning.",
                        a.totals().vertex_count, b.totals().vertex_count));
    }
    std::vector<Place> places;
    places.reserve(a.totals().vertex_count);
    PlaceSink first(places);
    run(a, first);
    std::vector<float> distances;
    distances.reserve(places.size());
    DistanceSink second(places, distances);
    run(b, second);
    return distances;
}

std::unique_ptr<View> make_difference_view(const Subject& subject, Scheme against, const std::string& name,
                                           const std::optional<Scale>& fixed) {
    return std::make_unique<DifferenceView>(subject, against, name, fixed);
}

}  // namespace tessera::views
