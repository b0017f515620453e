// Errors as colours.
#include "compare/heat_map.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace tessera::test {
namespace {

using namespace compare;

int brightness(const std::array<std::uint8_t, 3>& c) {
    return 299 * c[0] + 587 * c[1] + 114 * c[2];
}

TEST(HeatMap, GrowsBrighterAllTheWay) {
    int last = -1;
    for (int i = 0; i <= 100; ++i) {
        const int now = brightness(heat_colour(static_cast<float>(i) / 100.0f));
        EXPECT_GT(now, last) << i;
        last = now;
    }
    EXPECT_LT(brightness(heat_colour(0.0f)), 2000);
    EXPECT_GT(brightness(heat_colour(1.0f)), 240'000);
}

TEST(HeatMap, TakesAnyNumber) {
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(heat_colour(-infinity), heat_colour(0.0f));
    EXPECT_EQ(heat_colour(infinity), heat_colour(1.0f));
    EXPECT_EQ(heat_colour(std::numeric_limits<float>::quiet_NaN()), (std::array<std::uint8_t, 3>{255, 255, 255}));
}

TEST(HeatMap, PutsEveryErrorAtItsPixel) {
    std::vector<float> errors(300 * 140);
    for (std::size_t i = 0; i < errors.size(); ++i)
        errors[i] = static_cast<float>(i % 101) / 100.0f;
    const image::Image map = heat_map(errors, 300, 140);
    ASSERT_EQ(map.rgba.size(), errors.size() * 4);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const auto colour = heat_colour(errors[i]);
        ASSERT_TRUE(std::equal(colour.begin(), colour.end(), &map.rgba[i * 4])) << i;
        ASSERT_EQ(map.rgba[i * 4 + 3], 255);
    }
}

}  // namespace
}  // namespace tessera::test
