// Counts of pixels: tolerance, neighbours, hidden colours.
#include "compare/outliers.hpp"

#include "compare/pictures.hpp"

#include <gtest/gtest.h>

namespace tessera::test {
namespace {

using namespace compare;

image::Image with_pixel(image::Image picture, std::size_t x, std::size_t y, const Colour& colour) {
    for (std::size_t c = 0; c < 4; ++c)
        picture.rgba[(y * picture.width + x) * 4 + c] = static_cast<std::uint8_t>(colour[c]);
    return picture;
}

TEST(Outliers, ThereAreNoneBetweenAPictureAndItself) {
    const PixelCounts counts = count_pixels(drawing(40, 30), drawing(40, 30), 0);
    EXPECT_TRUE(counts.equal);
    EXPECT_EQ(counts.differing + counts.over_tolerance + counts.outliers, 0u);
    EXPECT_EQ(counts.max_difference, (std::array<int, 4>{}));
}

TEST(Outliers, AStepWithinTheToleranceIsNone) {
    const image::Image grey = flat(9, 9, {100, 100, 100, 255});
    const image::Image other = with_pixel(grey, 4, 4, {103, 100, 100, 255});
    EXPECT_EQ(count_pixels(grey, other, 2).outliers, 1u);
    EXPECT_EQ(count_pixels(grey, other, 3).outliers, 0u);
    EXPECT_EQ(count_pixels(grey, other, 3).differing, 1u);
    EXPECT_EQ(count_pixels(grey, other, 255).over_tolerance, 0u);
}

TEST(Outliers, ASinglePixelIsOneWhereverItIs) {
    const image::Image grey = flat(300, 140, {100, 100, 100, 255});
    for (const auto& [x, y] : {std::pair{0u, 0u}, {299u, 139u}, {255u, 127u}, {256u, 128u}, {100u, 50u}}) {
        for (std::size_t channel = 0; channel < 4; ++channel) {
            Colour colour{100, 100, 100, 255};
            colour[channel] = 180;
            const image::Image other = with_pixel(grey, x, y, colour);
            const PixelCounts counts = count_pixels(grey, other, 10);
            EXPECT_EQ(counts.outliers, 1u);
            EXPECT_EQ(counts.over_tolerance, 1u);
            EXPECT_EQ(counts.max_difference[channel], channel == 3 ? 75 : 80);
            EXPECT_EQ(count_pixels(other, grey, 10).outliers, 1u) << "symmetric";
            std::vector<bool> marks(std::size_t{300} * 140, false);
            EXPECT_EQ(mark_outliers(grey, other, 100), marks);
            marks[std::size_t{y} * 300 + x] = true;
            EXPECT_EQ(mark_outliers(grey, other, 10), marks);
        }
    }
}

TEST(Outliers, AnEdgeMayMoveByAPixelAndBeSmoothedDifferently) {
    const auto edge = [](int place, bool smooth) {
        return make_picture(40, 20, [&](int x, int) -> Colour {
            const int value = x < place ? 20 : (x == place && smooth ? 120 : 220);
            return {value, value, value, 255};
        });
    };
    const auto outliers = [](const image::Image& a, const image::Image& b) { return count_pixels(a, b, 0).outliers; };
    EXPECT_EQ(outliers(edge(10, false), edge(11, false)), 0u);
    EXPECT_EQ(outliers(edge(10, false), edge(10, true)), 0u);
    EXPECT_EQ(count_pixels(edge(10, false), edge(10, true), 0).over_tolerance, 20u);
    EXPECT_GT(outliers(edge(10, false), edge(13, false)), 0u);
    EXPECT_EQ(outliers(drawing(120, 90), drawing(120, 90, 1)), outliers(drawing(120, 90, 1), drawing(120, 90)));
}

TEST(Outliers, GrowWithNoiseAndShrinkWithTolerance) {
    const image::Image d = drawing(120, 90);
    std::uint64_t last = 0;
    for (const int strength : {10, 20, 40, 80, 127}) {
        const std::uint64_t now = count_pixels(d, noisy(d, strength), 4).outliers;
        EXPECT_GT(now, last);
        last = now;
    }
    for (const int tolerance : {8, 16, 32, 64, 128}) {
        const std::uint64_t now = count_pixels(d, noisy(d, 127), tolerance).outliers;
        EXPECT_LT(now, last);
        last = now;
    }
}

TEST(Outliers, HiddenColoursDifferButAreNone) {
    const image::Image a = flat(5, 5, {10, 20, 30, 0});
    const PixelCounts counts = count_pixels(a, flat(5, 5, {200, 100, 0, 0}), 0);
    EXPECT_FALSE(counts.equal);
    EXPECT_EQ(counts.differing, 25u);
    EXPECT_EQ(counts.over_tolerance, 0u);
    EXPECT_EQ(counts.outliers, 0u);
    EXPECT_EQ(count_pixels(a, flat(5, 5, {10, 20, 30, 255}), 254).outliers, 25u) << "alpha is a channel";
}

}  // namespace
}  // namespace tessera::test
