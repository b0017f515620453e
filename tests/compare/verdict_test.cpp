// PASS and FAIL.
#include "compare/verdict.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace tessera::test {
namespace {

using namespace compare;

Comparison differing(double flip_mean, std::uint64_t outliers) {
    Comparison comparison;
    comparison.flip_mean = flip_mean;
    comparison.pixels.equal = false;
    comparison.pixels.differing = 10;
    comparison.pixels.outliers = outliers;
    return comparison;
}

TEST(Verdict, WithoutGatesOnlyEqualBitsPass) {
    EXPECT_TRUE(judge({}, {}).pass);
    const Verdict verdict = judge(differing(0.0, 0), {});
    EXPECT_FALSE(verdict.pass);
    EXPECT_EQ(verdict.failures, std::vector<std::string>{"10 pixels differ, and no difference was allowed."});
}

TEST(Verdict, GatesHoldUpToAndWithTheirValue) {
    EXPECT_TRUE(judge(differing(0.01, 5), {.max_flip = 0.01, .max_outliers = 5}).pass);
    EXPECT_FALSE(judge(differing(0.0101, 5), {.max_flip = 0.01, .max_outliers = 5}).pass);
    EXPECT_FALSE(judge(differing(0.01, 6), {.max_flip = 0.01, .max_outliers = 5}).pass);
    EXPECT_EQ(judge(differing(0.02, 6), {.max_flip = 0.01, .max_outliers = 5}).failures.size(), 2u);
    EXPECT_TRUE(judge(differing(0.01, 6), {.max_flip = 0.01, .max_outliers = {}}).pass) << "gates are independent";
    EXPECT_TRUE(judge(differing(0.02, 5), {.max_flip = {}, .max_outliers = 5}).pass);
}

TEST(Verdict, WhatIsNoNumberFails) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(judge(differing(nan, 0), {.max_flip = 1.0, .max_outliers = {}}).pass);
}

}  // namespace
}  // namespace tessera::test
