#include "views/factor_view.hpp"

#include "views/colour_bar.hpp"
#include "views/paint.hpp"
#include "views/patch_sink.hpp"

#include <algorithm>
#include <bit>

namespace tessera::views {
namespace {

constexpr std::uint32_t one = 65536;

struct Side {
    double distance;  // 0 on the edge
    double factor;
};

/// The sides of a patch around a point; returns how many there are.
std::size_t sides_around(const PatchDomain& domain, const DomainPoint& point, std::array<Side, 4>& sides) {
    const double u = point.u, v = point.v;
    const PatchFactors& f = domain.factors();
    if (domain.domain() == Domain::quad) {
        sides = {{{u / one, f[0]}, {v / one, f[1]}, {(one - u) / one, f[2]}, {(one - v) / one, f[3]}}};
        return 4;
    }
    sides = {{{u / one, f[0]}, {v / one, f[1]}, {(one - u - v) / one, f[2]}, {0.0, 0.0}}};
    return 3;
}

double inside_factor(const PatchDomain& domain) {
    const PatchFactors& f = domain.factors();
    return domain.domain() == Domain::quad ? 0.5 * (double{f[4]} + f[5]) : f[3];
}

double segments_of(const HairOptions& options) {
    return options.segments;
}

class FactorSink final : public PatchSink {
public:
    FactorSink(Painter& painter, const Scale& scale, const Subject& subject, const Cell& cell)
        : PatchSink(subject.patches, cell.options, cell.tessellator->totals()),
          painter_(painter),
          scale_(scale),
          hair_place_(scale.place(segments_of(subject.hair_options))) {}

private:
    void take(const PatchOutput& output) override {
        const std::vector<DomainPoint> points = output.domain.points();
        vertices_.assign(output.vertices.begin(), output.vertices.end());
        indices_.assign(output.indices.begin(), output.indices.end());
        edges_.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            edges_[i] = edges_of(output.domain.domain(), points[i]);
            set_place(vertices_[i], scale_.place(factor_at(output.domain, points[i])));
        }
        for (std::size_t t = 0; t + 2 < indices_.size(); t += 3)
            colour_corners(output.domain, std::span(indices_).subspan(t, 3));
        painter_.add(output.material, vertices_, indices_);
    }

    /// Gives a triangle that lies along an edge a vertex of its own at the edge's end.
    void colour_corners(const PatchDomain& domain, std::span<std::uint32_t> triangle) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t corner = edges_[triangle[k]];
            if (std::popcount(corner) < 2) continue;
            std::uint32_t along = 0;
            for (std::size_t other = 1; other < 3; ++other)
                along |= corner & edges_[triangle[(k + other) % 3]];
            if (std::popcount(along) != 1) continue;
            const float factor = domain.factors()[static_cast<std::size_t>(std::countr_zero(along))];
            Vertex own = vertices_[triangle[k]];
            set_place(own, scale_.place(factor));
            triangle[k] = static_cast<std::uint32_t>(vertices_.size());
            vertices_.push_back(own);
            edges_.push_back(corner);
        }
    }

    void take_hair(std::uint32_t material, std::uint64_t, std::span<const Vertex> vertices,
                   std::span<const std::uint32_t> indices) override {
        vertices_.assign(vertices.begin(), vertices.end());
        for (Vertex& vertex : vertices_)
            set_place(vertex, hair_place_);
        painter_.add(material, vertices_, indices);
    }

    Painter& painter_;
    Scale scale_;
    double hair_place_;
    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> indices_, edges_;
};

class FactorView final : public View {
public:
    FactorView(const Subject& subject, const std::optional<Scale>& fixed)
        : subject_(subject), palette_(make_palette(subject.scene.materials)), fixed_(fixed.has_value()) {
        if (fixed) scale_ = *fixed;
    }

    void prepare(std::span<Cell> cells, const Run&) override {
        if (fixed_) return;
        scale_ = factor_scale(subject_, cells.front().options);
        for (const Cell& cell : cells.subspan(1)) {
            const Scale other = factor_scale(subject_, cell.options);
            scale_ = {std::min(scale_.least, other.least), std::max(scale_.greatest, other.greatest)};
        }
    }

    image::Image draw(Cell& cell, const render::Frame& frame, render::Rasteriser& rasteriser, const Run& run) override {
        rasteriser.begin(frame);
        rasteriser.set_materials(palette_.materials, palette_.images);
        Painter painter(rasteriser, frame);
        FactorSink sink(painter, scale_, subject_, cell);
        run(*cell.tessellator, sink);
        painter.flush();
        return rasteriser.finish();
    }

    void append_legend(image::Image& picture, const PanelSize& panel, const image::Rgba& paper) const override {
        append_colour_bar(picture, panel, scale_, "tessellation factor", paper);
    }

private:
    const Subject subject_;
    Palette palette_;
    bool fixed_;
    Scale scale_;
};

}  // namespace

double factor_at(const PatchDomain& domain, const DomainPoint& point) {
    std::array<Side, 4> sides{};
    const std::size_t count = sides_around(domain, point, sides);
    // Inverse distances, multiplied by all of them: nothing is divided by zero but in a corner.
    double sum = 0.0, weights = 0.0, middle = count == 3 ? 27.0 : 16.0;
    for (std::size_t i = 0; i < count; ++i) {
        double weight = 1.0;
        for (std::size_t k = 0; k < count; ++k)
            weight *= k == i ? 1.0 : sides[k].distance;
        sum += weight * sides[i].factor;
        weights += weight;
        middle *= sides[i].distance;
    }
    if (weights > 0.0) return (1.0 - middle) * (sum / weights) + middle * inside_factor(domain);
    double meeting = 0.0, met = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        if (sides[i].distance == 0.0) {
            meeting += sides[i].factor;
            met += 1.0;
        }
    }
    return meeting / met;
}

std::uint32_t edges_of(Domain domain, const DomainPoint& point) {
    std::uint32_t edges = (point.u == 0 ? 1u : 0u) | (point.v == 0 ? 2u : 0u);
    if (domain == Domain::quad) return edges | (point.u == one ? 4u : 0u) | (point.v == one ? 8u : 0u);
    return edges | (point.u + point.v == one ? 4u : 0u);
}

Scale factor_scale(const Subject& subject, const TessellationOptions& options) {
    Scale scale{1e30, -1e30};
    const auto add = [&](double factor) {
        scale.least = std::min(scale.least, factor);
        scale.greatest = std::max(scale.greatest, factor);
    };
    PatchDomains domains(subject.patches, options);
    for (std::uint64_t i = 0; i < domains.count(); ++i) {
        const PatchDomain& domain = domains[i];
        if (domain.index_count() == 0) continue;
        const std::size_t outer = domain.domain() == Domain::quad ? 4 : 3;
        for (std::size_t k = 0; k < outer; ++k)
            add(domain.factors()[k]);
        add(inside_factor(domain));
    }
    if (!subject.hair.empty()) add(segments_of(subject.hair_options));
    return scale.least <= scale.greatest ? scale : Scale{};
}

std::unique_ptr<View> make_factor_view(const Subject& subject, const std::optional<Scale>& fixed) {
    return std::make_unique<FactorView>(subject, fixed);
}

}  // namespace tessera::views
