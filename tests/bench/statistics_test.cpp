#include "bench/statistics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <algorithm>
#include <cmath>
#include <vector>

namespace tessera::bench {
namespace {

TEST(Summary, QuartilesOfKnownSamples) {
    const std::vector<double> samples{5, 1, 4, 2, 3};
    const Summary s = summarise(samples);
    EXPECT_EQ(s.median, 3.0);
    EXPECT_EQ(s.lower, 2.0);
    EXPECT_EQ(s.upper, 4.0);
    EXPECT_EQ(s.least, 1.0);
    EXPECT_EQ(s.greatest, 5.0);
    EXPECT_EQ(s.samples, 5u);
    EXPECT_EQ(summarise(std::vector<double>{1, 2}).median, 1.5);
    EXPECT_EQ(summarise({}).samples, 0u);
}

TEST(Summary, OneOutlierMovesNothing) {
    const Summary calm = summarise(std::vector<double>{1, 2, 3, 4, 5});
    const Summary disturbed = summarise(std::vector<double>{1, 2, 3, 4, 5000});
    EXPECT_EQ(calm.median, disturbed.median);
    EXPECT_EQ(calm.upper, disturbed.upper);
}

RC_GTEST_PROP(Summary, IsOrderedWhateverTheSamples, (std::vector<int> numbers)) {
    RC_PRE(!numbers.empty());
    std::vector<double> samples(numbers.begin(), numbers.end());
    const Summary s = summarise(samples);
    RC_ASSERT(s.least <= s.lower && s.lower <= s.median && s.median <= s.upper && s.upper <= s.greatest);
    std::ranges::reverse(samples);
    RC_ASSERT(summarise(samples).median == s.median);
}

TEST(Line, FindsTheLineThatPointsWereMadeFrom) {
    const std::vector<double> x{1, 10, 100, 1000};
    std::vector<double> y;
    std::vector<double> weights;
    for (const double value : x) {
        y.push_back(0.25 + 3.0 * value);
        weights.push_back(1.0 / (y.back() * y.back()));
    }
    for (const Line& line : {fit_line(x, y), fit_line(x, y, weights)}) {
        EXPECT_NEAR(line.constant, 0.25, 1e-9);
        EXPECT_NEAR(line.slope, 3.0, 1e-9);
        EXPECT_NEAR(line.r_squared, 1.0, 1e-12);
    }
}

TEST(Line, SaysHowBadlyItFits) {
    const std::vector<double> x{1, 2, 3, 4};
    EXPECT_LT(fit_line(x, std::vector<double>{1, -1, 1, -1}).r_squared, 0.5);
    EXPECT_EQ(fit_line(std::vector<double>{2, 2}, std::vector<double>{1, 3}).slope, 0.0);
}

}  // namespace
}  // namespace tessera::bench
