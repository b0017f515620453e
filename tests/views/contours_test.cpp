// Outlines in pictures of depths.
#include "views/contours.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <functional>

namespace tessera::views {
namespace {

DepthPicture picture(std::uint32_t width, std::uint32_t height,
                     const std::function<float(std::uint32_t, std::uint32_t)>& depth) {
    DepthPicture result{width, height, {}};
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x)
            result.depths.push_back(depth(x, y));
    }
    return result;
}

TEST(Contours, GoAroundWhatIsThere) {
    const auto found = find_contours(
        picture(9, 7, [](auto x, auto y) { return x >= 3 && x < 6 && y >= 2 && y < 4 ? 0.5f : -1.0f; }), 0.01f);
    EXPECT_EQ(found.size(), 2u * (3 + 2));
    for (const BorderPoint& p : found) {
        const bool upright = p.x2 == 6 || p.x2 == 12, level = p.y2 == 4 || p.y2 == 8;
        EXPECT_TRUE(upright || level) << p.x2 << ", " << p.y2;
    }
    EXPECT_TRUE(find_contours(picture(5, 5, [](auto, auto) { return 0.5f; }), 0.01f).empty())
        << "the picture's edge is no outline";
}

TEST(Contours, AreStepsOfDepthButNotSlopesOrRidges) {
    const auto count = [](const std::function<float(std::uint32_t)>& depth) {
        const auto found = find_contours(picture(20, 1, [&](auto x, auto) { return depth(x); }), 0.05f);
        return std::ranges::count_if(found, &BorderPoint::clear);
    };
    EXPECT_EQ(count([](auto x) { return x < 10 ? 0.3f : 0.4f; }), 1);
    EXPECT_EQ(count([](auto x) { return x < 10 ? 0.3f : 0.34f; }), 0) << "a small step";
    EXPECT_EQ(count([](auto x) { return 0.09f * static_cast<float>(x); }), 0) << "a slope";
    EXPECT_EQ(count([](auto x) { return 0.09f * static_cast<float>(x < 10 ? x : 20 - x); }), 0) << "a ridge";
    EXPECT_EQ(count([](auto x) { return x < 10 ? 0.9f : 0.1f + 0.08f * static_cast<float>(x); }), 0) << "a crease";
    EXPECT_EQ(count([](auto x) { return (x < 10 ? 0.01f : 0.2f) + 0.02f * static_cast<float>(x); }), 1)
        << "a step on a slope";
}

TEST(Contours, ThatAreShortOrUnclearAreLeftOut) {
    std::vector<BorderPoint> points;
    for (std::int32_t x = 0; x < 20; ++x)
        points.push_back({2 * x + 1, 10, x < 12});  // 12 clear ones, and 8 that go on from them
    for (std::int32_t x = 0; x < 30; ++x)
        points.push_back({2 * x + 1, 50, x % 7 == 0});  // long, but hardly any of it is clear
    for (std::int32_t x = 0; x < 9; ++x)
        points.push_back({2 * x + 1, 90});  // clear, but short
    const std::vector<BorderPoint> kept = long_contours(points, 10);
    EXPECT_EQ(kept.size(), 20u);
    for (const BorderPoint& p : kept)
        EXPECT_EQ(p.y2, 10);
    EXPECT_EQ(long_contours(points, 9).size(), 29u);
    EXPECT_TRUE(long_contours({}, 1).empty());
}

TEST(Contours, AreDrawnAsWideAsAsked) {
    image::Image drawn{20, 10, std::vector<std::uint8_t>(std::size_t{20} * 10 * 4, 255)};
    std::vector<BorderPoint> line;  // across the middle, found in a picture three times as large
    for (std::int32_t x = 0; x < 60; ++x)
        line.push_back({2 * x + 1, 30});
    draw_contours(drawn, line, 3, 2.0f, {0, 0, 0, 255});
    for (const std::size_t x : {0u, 10u, 19u}) {
        double ink = 0.0;
        for (std::size_t y = 0; y < 10; ++y)
            ink += 1.0 - drawn.rgba[4 * (y * 20 + x)] / 255.0;
        EXPECT_NEAR(ink, 2.0, 0.35) << x;
    }
    EXPECT_EQ(drawn.rgba[4 * (3 * 20 + 5)], 255);
    EXPECT_EQ(drawn.rgba[4 * (4 * 20 + 5)], 0);
}

}  // namespace
}  // namespace tessera::views
