// Outlines of surfaces.
#include "views/silhouette_view.hpp"

#include "raster/portable_rasteriser.hpp"
#include "small_picture.hpp"
#include "views/depth_picture.hpp"

#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <numbers>

namespace tessera::test {
namespace {

constexpr std::uint32_t size = 250;

image::Image draw(Stage& stage, Scheme scheme) {
    TessellationOptions options;
    options.scheme = scheme;
    options.factors = PatchFactors{8, 8, 8, 8, 8, 8};
    std::vector<views::Cell> cells;
    cells.push_back(stage.cell(options));
    const auto view = views::make_silhouette_view(stage.subject, raster::open_portable(stage.device));
    view->prepare(cells, plain_run());
    const auto rasteriser = raster::open_portable(stage.device);
    return view->draw(cells[0], front_frame(size), *rasteriser, plain_run());
}

/// Places of pixels that are nearly all of one ink.
std::vector<glm::dvec2> inked(const image::Image& picture, const image::Rgba& ink) {
    std::vector<glm::dvec2> found;
    for (std::uint32_t y = 0; y < picture.height; ++y) {
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            if (apart(pixel(picture, x, y), ink) < 40) found.emplace_back(x + 0.5 - 0.5 * size, y + 0.5 - 0.5 * size);
        }
    }
    return found;
}

TEST(Silhouette, OfASphereIsARing) {
    Stage stage(scene::load_scene("shape:sphere:8"));
    const std::vector<glm::dvec2> ring = inked(draw(stage, Scheme::pn), views::refined_ink);
    const double radius = size / 2.5;
    std::array<int, 36> directions{};
    for (const glm::dvec2& place : ring) {
        EXPECT_NEAR(glm::length(place), radius, 1.6);
        const double turn = (std::atan2(place.y, place.x) + std::numbers::pi) / (2.0 * std::numbers::pi);
        ++directions[std::min<std::size_t>(static_cast<std::size_t>(turn * 36.0), 35)];
    }
    for (const int count : directions)
        EXPECT_GT(count, 8);
}

TEST(Silhouette, ShowsHowMuchTheCoarseMeshLacks) {
    Stage stage(scene::load_scene("shape:sphere:1"));  // an octahedron: a square, seen from the front
    const image::Image picture = draw(stage, Scheme::pn);
    const std::vector<glm::dvec2> coarse = inked(picture, views::coarse_ink);
    EXPECT_GT(coarse.size(), 200u);
    for (const glm::dvec2& place : coarse)
        EXPECT_NEAR(std::abs(place.x) + std::abs(place.y), size / 2.5, 2.5);
    for (const glm::dvec2& place : inked(picture, views::refined_ink))
        EXPECT_GT(std::abs(place.x) + std::abs(place.y), size / 2.5 - 3.0);
    // Flat patches leave nothing of it: the refined line covers the coarse one.
    EXPECT_LT(inked(draw(stage, Scheme::linear), views::coarse_ink).size(), 4u);
}

TEST(DepthPicture, HasSixteenThousandSteps) {
    // A square that leans back: depth is linear in x.
    scene::Scene scene = square(true);
    for (glm::vec3& position : scene.meshes[0].positions)
        position.z = -position.x;
    Stage stage(scene);
    TessellationOptions options;
    options.scheme = Scheme::linear;
    views::Cell cell = stage.cell(options);
    const auto rasteriser = raster::open_portable(stage.device);
    const views::DepthPicture depths =
        views::draw_depths(*cell.tessellator, scene.materials, front_frame(500), *rasteriser, plain_run());
    // 200 pixels to a unit; the depths 1.5 times the range of two units.
    EXPECT_LT(depths.depths[250 * 500 + 2], 0.0f);
    for (std::uint32_t x = 55; x < 445; ++x) {
        const double wanted = 0.5 + (x + 0.5 - 250.0) / 200.0 / 3.0;
        ASSERT_NEAR(depths.depths[250 * 500 + x], wanted, 1e-4) << x;
    }
}

}  // namespace
}  // namespace tessera::test
