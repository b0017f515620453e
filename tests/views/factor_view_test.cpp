// Tessellation factors as colours.
#include "views/factor_view.hpp"

#include "raster/portable_rasteriser.hpp"
#include "small_picture.hpp"
#include "tessellate/edge_factors.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <map>

namespace tessera::test {
namespace {

using views::Scale;

views::PatchDomain triangle(const PatchFactors& factors) {
    return {Domain::triangle, Partitioning::integer, factors};
}

TEST(FactorAt, AnEdgeIsItsOwnAndTheMiddleTheInside) {
    const views::PatchDomain t = triangle({2, 4, 6, 8, 0, 0});
    for (const std::uint32_t along : {1u, 1000u, 32768u, 65535u}) {
        EXPECT_EQ(views::factor_at(t, {0, along}), 2.0);
        EXPECT_EQ(views::factor_at(t, {along, 0}), 4.0);
        EXPECT_EQ(views::factor_at(t, {along, 65536 - along}), 6.0);
    }
    EXPECT_NEAR(views::factor_at(t, {0x5555, 0x5555}), 8.0, 1e-6);
    EXPECT_EQ(views::factor_at(t, {65536, 0}), 5.0) << "a corner has the mean of its edges";
    const views::PatchDomain q(Domain::quad, Partitioning::integer, {2, 4, 6, 8, 10, 20});
    EXPECT_EQ(views::factor_at(q, {0, 30000}), 2.0);
    EXPECT_EQ(views::factor_at(q, {30000, 0}), 4.0);
    EXPECT_EQ(views::factor_at(q, {65536, 30000}), 6.0);
    EXPECT_EQ(views::factor_at(q, {30000, 65536}), 8.0);
    EXPECT_EQ(views::factor_at(q, {32768, 32768}), 15.0);
    EXPECT_EQ(views::factor_at(q, {65536, 65536}), 7.0);
}

/// Draws factors of the square, which covers the middle four fifths of the picture.
image::Image draw_square(std::uint32_t size, bool quad, const PatchFactors& factors, const Scale& scale) {
    Stage stage(square(quad));
    TessellationOptions options;
    options.factors = factors;
    std::vector<views::Cell> cells;
    cells.push_back(stage.cell(options));
    const auto view = views::make_factor_view(stage.subject, scale);
    view->prepare(cells, plain_run());
    const auto rasteriser = raster::open_portable(stage.device);
    return view->draw(cells[0], front_frame(size), *rasteriser, plain_run());
}

TEST(FactorView, AFactorHasTheColourOfTheBar) {
    for (const float factor : {1.0f, 3.0f, 9.0f}) {
        const image::Image picture =
            draw_square(64, true, {factor, factor, factor, factor, factor, factor}, Scale{1.0, 9.0});
        const image::Rgba wanted = views::map_colour((double{factor} - 1.0) / 8.0);
        for (const std::uint32_t x : {8u, 20u, 32u, 50u})
            EXPECT_LE(apart(pixel(picture, x, 31), wanted), 1) << factor << " at " << x;
        EXPECT_EQ(pixel(picture, 2, 31)[3], 0);
    }
}

TEST(FactorView, EdgesAndTheInsideHaveColoursOfTheirOwn) {
    // Edge U=0 is the left one, V=0 the lower one.
    const image::Image picture = draw_square(1000, true, {1, 3, 5, 7, 9, 9}, Scale{1.0, 9.0});
    const auto at = [](double factor) { return views::map_colour((factor - 1.0) / 8.0); };
    EXPECT_LE(apart(pixel(picture, 101, 500), at(1)), 6);
    EXPECT_LE(apart(pixel(picture, 500, 898), at(3)), 6);
    EXPECT_LE(apart(pixel(picture, 898, 500), at(5)), 6);
    EXPECT_LE(apart(pixel(picture, 500, 101), at(7)), 6);
    EXPECT_LE(apart(pixel(picture, 500, 500), at(9)), 10) << "an odd factor has no point in the middle";
}

TEST(FactorView, TheScaleHoldsAllFactors) {
    Stage stage(square(false));
    TessellationOptions options;
    options.factors = PatchFactors{2, 9.5f, 3, 5, 0, 0};
    const Scale scale = views::factor_scale(stage.subject, options);
    EXPECT_EQ(scale.least, 2.0);
    EXPECT_EQ(scale.greatest, 9.5);
    options.factors = std::vector<PatchFactors>{{0, 1, 1, 1, 0, 0}, {4, 4, 4, 4, 0, 0}};
    EXPECT_EQ(views::factor_scale(stage.subject, options).least, 4.0) << "culled patches do not count";
}

/// Bits of a position.
using Place = std::array<float, 3>;

Place place(const Vertex& vertex) {
    return {vertex.position[0], vertex.position[1], vertex.position[2]};
}

/// Whether a point lies on an edge of a flat patch.
bool is_on_edge(const patches::PatchSet& patches, const Place& p) {
    const glm::vec3 point(p[0], p[1], p[2]);
    return std::ranges::any_of(patches.corners, [&](const patches::PatchCorners& corners) {
        const std::size_t count = patches::is_quad(corners) ? 4 : 3;
        for (std::size_t k = 0; k < count; ++k) {
            const Place from = place(patches.control_vertices[corners[k]]);
            const Place to = place(patches.control_vertices[corners[(k + 1) % count]]);
            const glm::vec3 a(from[0], from[1], from[2]), b(to[0], to[1], to[2]);
            if (glm::distance(a, point) + glm::distance(point, b) < glm::distance(a, b) + 1e-5f) return true;
        }
        return false;
    });
}

TEST(FactorView, ACommonEdgeHasItsColourOnBothSidesFromEndToEnd) {
    Stage stage(scene::load_scene("shape:icosahedron"));
    TessellationOptions options;
    options.scheme = Scheme::linear;
    options.factors = random_edge_factors(stage.patches, 2.0f, 9.0f, 3);
    std::vector<views::Cell> cells;
    cells.push_back(stage.cell(options));
    const auto view = views::make_factor_view(stage.subject, {});
    view->prepare(cells, plain_run());
    Recorder recorder;
    render::Frame frame = front_frame(64);
    frame.camera.projection = glm::mat4(0.0f);  // seen from nowhere, no triangle is too thin for its colours
    view->draw(cells[0], frame, recorder, plain_run());

    // The colours at both ends of a segment, for each of the triangles beside it.
    std::map<std::pair<Place, Place>, std::vector<std::pair<float, float>>> segments;
    for (const Recorder::Triangle& t : recorder.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vertex* a = &t.corners[k];
            const Vertex* b = &t.corners[(k + 1) % 3];
            if (place(*b) < place(*a)) std::swap(a, b);
            segments[{place(*a), place(*b)}].emplace_back(a->uv[0], b->uv[0]);
        }
    }
    std::size_t along_edges = 0;
    for (const auto& [segment, colours] : segments) {
        const auto& [a, b] = segment;
        const Place middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
        if (!is_on_edge(stage.patches, a) || !is_on_edge(stage.patches, b) || !is_on_edge(stage.patches, middle)) {
            continue;
        }
        ++along_edges;
        ASSERT_EQ(colours.size(), 2u) << "the model is closed";
        ASSERT_EQ(colours[0], colours[1]);
        ASSERT_EQ(colours[0].first, colours[0].second) << "one colour all along";
    }
    EXPECT_GT(along_edges, 100u);
}

}  // namespace
}  // namespace tessera::test
