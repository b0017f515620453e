// Colours and their legend.
#include "views/colour_bar.hpp"

#include "small_picture.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tessera::views {
namespace {

TEST(ColourMap, BeginsVioletAndEndsYellow) {
    EXPECT_EQ(map_colour(0.0), (image::Rgba{0x44, 0x01, 0x54, 255}));
    EXPECT_EQ(map_colour(1.0), (image::Rgba{0xfd, 0xe7, 0x25, 255}));
    EXPECT_EQ(map_colour(-3.0), map_colour(0.0));
    EXPECT_EQ(map_colour(7.0), map_colour(1.0));
    EXPECT_EQ(map_colour(4.0 / 9.0), (image::Rgba{0x26, 0x82, 0x8e, 255}));
}

TEST(ColourMap, ScalesMapTheirEnds) {
    const Scale scale{2.0, 6.0};
    EXPECT_EQ(scale.place(2.0), 0.0);
    EXPECT_EQ(scale.place(3.0), 0.25);
    EXPECT_EQ(scale.place(9.0), 1.0);
    EXPECT_EQ(scale.place(-9.0), 0.0);
    EXPECT_EQ(scale.place(std::numeric_limits<double>::quiet_NaN()), 0.0);
    EXPECT_EQ((Scale{4.0, 4.0}.place(4.0)), 0.5);
}

TEST(ColourBar, TicksAreRoundNumbersBetweenTheEnds) {
    EXPECT_EQ(bar_ticks({1.0, 9.0}, 6), (std::vector<double>{1, 2, 4, 6, 8, 9}));
    EXPECT_EQ(bar_ticks({0.0, 1.0}, 5), (std::vector<double>{0, 0.2, 0.4, 0.2 * 3, 0.8, 1}));
    EXPECT_EQ(bar_ticks({4.0, 4.0}, 6), (std::vector<double>{4}));
    for (const Scale& scale : {Scale{0.0, 1e-12}, Scale{-3e7, 5e8}, Scale{1.0, 1.0 + 1e-9}}) {
        const std::vector<double> ticks = bar_ticks(scale, 6);
        EXPECT_GE(ticks.size(), 3u);
        EXPECT_LE(ticks.size(), 10u);
        EXPECT_TRUE(std::ranges::is_sorted(ticks));
    }
}

TEST(ColourBar, NumbersHaveThreeDigitsOfTheScale) {
    EXPECT_EQ(tick_text(4.0, {1.0, 9.0}), "4");
    EXPECT_EQ(tick_text(1.6519, {0.0, 1.6519}), "1.65");
    EXPECT_EQ(tick_text(0.0123456, {0.0, 0.0123456}), "0.0123");
    EXPECT_EQ(tick_text(1200.0, {0.0, 1234.5}), "1200");
    EXPECT_EQ(tick_text(4.0, {4.0, 4.0}), "4");
    EXPECT_EQ(tick_text(2.5e-9, {0.0, 5e-9}), "2.5e-09");
}

TEST(ColourBar, ShowsTheMapUnderThePicture) {
    const image::Rgba paper{255, 255, 255, 255};
    image::Image picture{400, 300, std::vector<std::uint8_t>(std::size_t{400} * 300 * 4, 9)};
    append_colour_bar(picture, {400, 300}, {1.0, 9.0}, "factor", paper);
    ASSERT_EQ(picture.width, 400u);
    ASSERT_GT(picture.height, 320u);
    ASSERT_EQ(picture.rgba.size(), std::size_t{picture.height} * 400 * 4);
    EXPECT_EQ(test::pixel(picture, 7, 299)[0], 9) << "the picture stays";
    // One row of the bar: all colours from left to right.
    std::uint32_t row = 300;
    while (row < picture.height && test::apart(test::pixel(picture, 200, row), map_colour(0.5)) > 2)
        ++row;
    ASSERT_LT(row, picture.height);
    EXPECT_LE(test::apart(test::pixel(picture, 81, row), map_colour(0.0)), 6);
    EXPECT_LE(test::apart(test::pixel(picture, 318, row), map_colour(1.0)), 6);
    EXPECT_EQ(test::pixel(picture, 70, row), paper);
}

/// Columns of a picture, under its first `top` rows, that are not paper.
std::pair<std::uint32_t, std::uint32_t> inked_columns(const image::Image& picture, std::uint32_t top) {
    std::uint32_t first = picture.width, last = 0;
    for (std::uint32_t y = top; y < picture.height; ++y) {
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            if (test::pixel(picture, x, y) == image::Rgba{255, 255, 255, 255}) continue;
            first = std::min(first, x);
            last = std::max(last, x);
        }
    }
    return {first, last};
}

TEST(ColourBar, LegendsFitNarrowPictures) {
    const image::Rgba paper{255, 255, 255, 255};
    for (const std::uint32_t width : {140u, 200u, 460u}) {
        const image::Image blank{width, 300, std::vector<std::uint8_t>(std::size_t{width} * 300 * 4, 255)};
        image::Image bar = blank, keys = blank;
        append_colour_bar(bar, {width, 300}, {0.0, 1.0}, "distance to linear, % of the diagonal", paper);
        append_keys(keys, {width, 300}, {{{1, 2, 3, 255}, "refined surface"}, {{4, 5, 6, 255}, "coarse mesh"}}, paper);
        for (const image::Image& made : {bar, keys}) {
            const auto [first, last] = inked_columns(made, 300);
            EXPECT_GT(first, 0u) << width;
            EXPECT_LT(last, width - 1) << width;
            EXPECT_NEAR(first, width - 1 - last, 0.1 * width) << "in the middle of " << width;
        }
    }
}

TEST(ColourBar, KeysHaveTheirColours) {
    const image::Rgba paper{255, 255, 255, 255}, red{255, 0, 0, 255}, blue{0, 0, 255, 255};
    image::Image picture{400, 300, std::vector<std::uint8_t>(std::size_t{400} * 300 * 4, 9)};
    append_keys(picture, {400, 300}, {{red, "one"}, {blue, "other"}}, paper);
    std::uint32_t reds = 0, blues = 0;
    for (std::uint32_t y = 300; y < picture.height; ++y) {
        for (std::uint32_t x = 0; x < 400; ++x) {
            reds += test::pixel(picture, x, y) == red ? 1 : 0;
            blues += test::pixel(picture, x, y) == blue ? 1 : 0;
        }
    }
    EXPECT_GT(reds, 10u);
    EXPECT_EQ(reds, blues);
}

}  // namespace
}  // namespace tessera::views
