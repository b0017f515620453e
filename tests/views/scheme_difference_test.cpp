// Distances between schemes.
#include "views/scheme_difference.hpp"

#include "raster/portable_rasteriser.hpp"
#include "small_picture.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

namespace tessera::test {
namespace {

TessellationOptions with(Scheme scheme) {
    TessellationOptions options;
    options.scheme = scheme;
    options.partitioning = Partitioning::integer;
    options.factors = PatchFactors{6, 6, 6, 6, 6, 6};
    return options;
}

std::vector<float> distances(Stage& stage, Scheme a, Scheme b) {
    views::Cell first = stage.cell(with(a)), second = stage.cell(with(b));
    return views::scheme_distances(*first.tessellator, *second.tessellator, plain_run());
}

TEST(SchemeDistance, IsZeroForTheSameScheme) {
    Stage stage(scene::load_scene("shape:icosahedron"));
    for (const Scheme scheme : {Scheme::linear, Scheme::pn}) {
        const std::vector<float> apart = distances(stage, scheme, scheme);
        ASSERT_FALSE(apart.empty());
        EXPECT_EQ(std::ranges::count(apart, 0.0f), static_cast<std::ptrdiff_t>(apart.size()));
    }
}

TEST(SchemeDistance, OfPhongIsWhatThePaperSays) {
    // Vertices and normals are those of the unit sphere. Boubekeur and Alexa: the middle p of a face, |p|^2 = (1 +
    // 2c)/3 with c the cosine between two corners, is projected to the corners' tangent planes, the mean of which is (1
    // + 2 (1 - c) / 3) p; the surface takes the share alpha of the way. It is the farthest point of the face.
    Stage stage(scene::load_scene("shape:icosahedron"));
    const double c = 1.0 / std::sqrt(5.0);
    const double wanted = 0.75 * 2.0 * (1.0 - c) / 3.0 * std::sqrt((1.0 + 2.0 * c) / 3.0);
    const std::vector<float> apart = distances(stage, Scheme::linear, Scheme::phong);
    // Kernel space has another unit: the corner's own length tells it.
    const float* const corner = stage.patches.control_vertices.front().position;
    const double unit =
        std::sqrt(double{corner[0]} * corner[0] + double{corner[1]} * corner[1] + double{corner[2]} * corner[2]);
    EXPECT_NEAR(*std::ranges::max_element(apart), wanted * unit, 1e-5);
    // Corners stay.
    EXPECT_LT(*std::ranges::min_element(apart), 1e-6);
}

TEST(SchemeDistance, DiagonalIsThatOfTheCorners) {
    scene::Scene scene = square(false);
    scene.meshes[0].positions.push_back({50, 0, 0});  // no face uses it
    scene.meshes[0].normals.push_back({0, 0, 1});
    scene.meshes[0].uvs.push_back({0, 0});
    const Stage stage(scene);
    EXPECT_NEAR(views::patch_diagonal(stage.patches), std::sqrt(8.0), 1e-6);
    EXPECT_EQ(views::patch_diagonal({}), 1.0);
}

TEST(SchemeDistance, NeedsEqualDomainPoints) {
    Stage stage(scene::load_scene("shape:icosahedron"));
    TessellationOptions finer = with(Scheme::pn);
    finer.factors = PatchFactors{8, 8, 8, 8, 8, 8};
    views::Cell a = stage.cell(with(Scheme::pn)), b = stage.cell(finer);
    EXPECT_ANY_THROW(views::scheme_distances(*a.tessellator, *b.tessellator, plain_run()));
}

/// The u of what a view draws of each scheme.
std::vector<float> shown(Stage& stage, const std::vector<Scheme>& schemes, std::size_t which) {
    std::vector<views::Cell> cells;
    for (const Scheme scheme : schemes)
        cells.push_back(stage.cell(with(scheme)));
    const auto view = views::make_difference_view(stage.subject, Scheme::linear, "linear", {});
    view->prepare(cells, plain_run());
    Recorder recorder;
    view->draw(cells[which], front_frame(4096), recorder, plain_run());
    std::vector<float> places;
    for (const Recorder::Triangle& t : recorder.triangles) {
        for (const Vertex& vertex : t.corners)
            places.push_back(vertex.uv[0]);
    }
    return places;
}

TEST(DifferenceView, HasOneScaleForAllCells) {
    Stage stage(scene::load_scene("shape:icosahedron"));
    const std::vector<float> phong = shown(stage, {Scheme::linear, Scheme::phong, Scheme::pn}, 1);
    const std::vector<float> pn = shown(stage, {Scheme::linear, Scheme::phong, Scheme::pn}, 2);
    const std::vector<float> linear = shown(stage, {Scheme::linear, Scheme::phong, Scheme::pn}, 0);
    EXPECT_FLOAT_EQ(*std::ranges::max_element(linear), views::map_u(0.0));
    const float most = std::max(*std::ranges::max_element(phong), *std::ranges::max_element(pn));
    EXPECT_FLOAT_EQ(most, views::map_u(1.0));
    EXPECT_NE(*std::ranges::max_element(phong), *std::ranges::max_element(pn)) << "one of them lies lower on it";
    const std::vector<float> alone = shown(stage, {Scheme::pn}, 0);
    EXPECT_FLOAT_EQ(*std::ranges::max_element(alone), views::map_u(1.0)) << "alone it does not";
}

TEST(DifferenceView, FlatIsDarkEverywhere) {
    Stage stage(square(true));
    std::vector<views::Cell> cells;
    cells.push_back(stage.cell(with(Scheme::pn)));  // of a flat square with normals across it
    const auto view = views::make_difference_view(stage.subject, Scheme::linear, "linear", {});
    view->prepare(cells, plain_run());
    const auto rasteriser = raster::open_portable(stage.device);
    const image::Image picture = view->draw(cells[0], front_frame(32), *rasteriser, plain_run());
    for (const std::uint32_t x : {5u, 16u, 26u})
        EXPECT_LE(apart(pixel(picture, x, 16), views::map_colour(0.0)), 1) << x;
}

}  // namespace
}  // namespace tessera::test
