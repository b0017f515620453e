#include "measure/silhouette.hpp"

#include "backends/registry.hpp"
#include "base/error.hpp"
#include "raster/portable_rasteriser.hpp"
#include "surfaces.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace tessera {
namespace {

image::Image covered(std::uint32_t size, std::uint32_t from, std::uint32_t to) {
    image::Image picture{size, size, std::vector<std::uint8_t>(std::size_t{4} * size * size, 0)};
    for (std::uint32_t y = from; y < to; ++y) {
        for (std::uint32_t x = from; x < to; ++x)
            picture.rgba[4 * (y * size + x) + 3] = 255;
    }
    return picture;
}

TEST(Silhouette, DifferenceOfSquares) {
    const image::Image small = covered(10, 3, 7);
    image::Image large = covered(10, 2, 8);
    EXPECT_EQ(measure::compare_silhouettes(small, small).differing, 0u);
    const measure::SilhouetteDifference difference = measure::compare_silhouettes(small, large);
    EXPECT_EQ(difference.differing, 36u - 16u);
    EXPECT_DOUBLE_EQ(difference.area, 20.0);
    large.rgba[4 * (2 * 10 + 2) + 3] = 51;  // a fifth
    EXPECT_NEAR(measure::compare_silhouettes(large, small).area, 19.2, 1e-12);
    large.rgba[0] = 200;  // colour does not count
    EXPECT_EQ(measure::compare_silhouettes(large, small).differing, 20u);
    EXPECT_THROW(measure::compare_silhouettes(small, covered(9, 3, 7)), Error);
}

TEST(Silhouette, OutlineOfSquares) {
    EXPECT_EQ(measure::outline_pixels(covered(10, 3, 7)), 12u);
    EXPECT_EQ(measure::outline_pixels(covered(10, 0, 10)), 36u);  // the picture's edge is an outline too
    EXPECT_EQ(measure::outline_pixels(covered(10, 5, 5)), 0u);
}

TEST(Silhouette, OfASphereIsADisc) {
    const auto rasteriser = raster::open_portable(backends::open_device("reference"));
    const auto sphere = test::make_surface(test::load_patches("shape:sphere:16"), {}, 2);
    render::View view;
    view.projection = render::Projection::orthographic;
    render::Framing framing(view, 1.0f);
    for (const Vertex& v : sphere.vertices)
        framing.add({v.position[0], v.position[1], v.position[2]});
    const std::uint32_t size = 200;
    const image::Image disc = measure::draw_surface(*rasteriser, sphere, framing.camera(), size);
    const double radius = 0.5 * render::fill * size;
    const double area = measure::compare_silhouettes(disc, covered(size, 0, 0)).area;
    EXPECT_NEAR(area, std::numbers::pi * radius * radius, 0.01 * area);
    const auto outline = static_cast<double>(measure::outline_pixels(disc));
    EXPECT_GT(outline, 5 * radius);  // a circle crosses about 8 r pixels
    EXPECT_LT(outline, 10 * radius);
}

TEST(Silhouette, IsDrawnFromBehindToo) {
    const auto rasteriser = raster::open_portable(backends::open_device("reference"));
    const auto sheet = test::make_surface(test::folded_sheet(0.0, false), {}, 1);
    const image::Image nothing = covered(100, 0, 0);
    for (const double azimuth : {0.0, std::numbers::pi}) {
        const render::Camera camera = measure::frame_surface(sheet, static_cast<float>(azimuth));
        const image::Image picture = measure::draw_surface(*rasteriser, sheet, camera, 100);
        EXPECT_GT(measure::compare_silhouettes(picture, nothing).area, 1000.0) << azimuth;
    }
}

}  // namespace
}  // namespace tessera
