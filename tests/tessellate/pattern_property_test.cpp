// The invariants of the triangle domain over random factors and every combination of those at which something changes.
#include "support/devices.hpp"
#include "tessellate/factor_generators.hpp"
#include "tessellate/pattern_checks.hpp"

#include <rapidcheck/gtest.h>

#include <random>

namespace tessera {
namespace {

using test::check_triangle_pattern;
using test::random_factor;

constexpr Partitioning partitionings[] = {Partitioning::integer, Partitioning::pow2, Partitioning::fractional_odd,
                                          Partitioning::fractional_even, Partitioning::uniform};

bool is_integer(Partitioning p) {
    return p == Partitioning::integer || p == Partitioning::pow2 || p == Partitioning::uniform;
}

std::vector<Pattern> make(Partitioning partitioning, const std::vector<PatchFactors>& factors) {
    return make_patterns(test::open_device("reference"), Domain::triangle, partitioning, true, factors);
}

/// The first problem of many patterns, or nothing.
std::string check_all(Partitioning partitioning, const std::vector<PatchFactors>& factors) {
    const std::vector<Pattern> patterns = make(partitioning, factors);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const std::string problem = check_triangle_pattern(partitioning, factors[i], patterns[i]);
        if (!problem.empty()) {
            return problem;
        }
        if (is_integer(partitioning) && test::inverted_or_empty(patterns[i]) > 0) {
            return test::describe(partitioning, factors[i]) + ": a triangle is inverted or has no area";
        }
    }
    return {};
}

/// Every combination of four of these.
std::vector<PatchFactors> combinations(const std::vector<float>& values) {
    std::vector<PatchFactors> factors;
    for (const float a : values)
        for (const float b : values)
            for (const float c : values)
                for (const float inside : values)
                    factors.push_back({a, b, c, inside, 0, 0});
    return factors;
}

std::vector<PatchFactors> random_factors(std::uint32_t seed, std::size_t count) {
    std::mt19937 random(seed);
    std::vector<PatchFactors> factors(count);
    for (PatchFactors& f : factors) {
        f = {random_factor(random), random_factor(random), random_factor(random), random_factor(random), 0, 0};
    }
    return factors;
}

class PatternProperty : public testing::TestWithParam<Partitioning> {};

TEST_P(PatternProperty, HoldsForCombinationsOfIntegers) {
    EXPECT_EQ(check_all(GetParam(), combinations({1, 2, 3, 4, 7, 8, 63, 64})), "");
}

TEST_P(PatternProperty, HoldsForCombinationsOfBoundaryValues) {
    EXPECT_EQ(check_all(GetParam(), combinations({1e-40f, 1.0f, 0x1.00008p0f, 0x1.0000a2p0f, 0x1.0001p0f, 1.99999f,
                                                  2.0f, 2.00001f, 3.00001f, 1e30f})),
              "");
}

TEST_P(PatternProperty, HoldsForSampledIntegers) {
    std::mt19937 random(11);
    std::vector<PatchFactors> factors(1500);
    for (PatchFactors& f : factors) {
        for (std::size_t i = 0; i < 4; ++i)
            f[i] = static_cast<float>(1 + random() % 64);
    }
    EXPECT_EQ(check_all(GetParam(), factors), "");
}

TEST_P(PatternProperty, HoldsForAFixedSeed) {
    EXPECT_EQ(check_all(GetParam(), random_factors(42, 1500)), "");
}

TEST_P(PatternProperty, HoldsForFreshSeeds) {
    EXPECT_TRUE(rc::check([] {
        const auto seed = *rc::gen::arbitrary<std::uint32_t>();
        RC_ASSERT(check_all(GetParam(), random_factors(seed, 10)) == "");
    }));
}

// Where each edge has its own factor. The edges of the even grid are looked at in uniform_test.cpp.
class EdgeProperty : public testing::TestWithParam<Partitioning> {};

// What a neighbour relies on.
TEST_P(EdgeProperty, OuterPointsDependOnTheirOwnFactorOnlyAndAreSymmetric) {
    std::mt19937 random(5);
    std::vector<PatchFactors> factors;
    std::vector<float> shared;
    for (int i = 0; i < 400; ++i) {
        shared.push_back(random_factor(random));
        for (std::size_t edge = 0; edge < 3; ++edge) {
            // The other factors exceed one, or all four could be one: a pattern of its own.
            PatchFactors f{5.5f, 2.25f, 9.0f, 3.5f, 0, 0};
            f[(edge + 1) % 3] = 1.5f + std::fabs(random_factor(random));
            f[3] = 1.5f + std::fabs(random_factor(random));
            f[edge] = shared.back();
            factors.push_back(f);
        }
    }
    const std::vector<Pattern> patterns = make(GetParam(), factors);
    for (std::size_t i = 0; i < shared.size(); ++i) {
        std::vector<std::uint32_t> first;
        for (int edge = 0; edge < 3; ++edge) {
            const std::size_t at = 3 * i + static_cast<std::size_t>(edge);
            const std::vector<std::uint32_t> own = test::outer_edge(GetParam(), factors[at], patterns[at], edge);
            first = edge == 0 ? own : first;
            EXPECT_EQ(own, first) << test::describe(GetParam(), factors[at]) << " edge " << edge;
            for (std::size_t k = 0; k < own.size(); ++k) {
                ASSERT_EQ(own[k], 65536 - own[own.size() - 1 - k]) << test::describe(GetParam(), factors[at]);
            }
            EXPECT_EQ(own.front(), 0u);
            EXPECT_EQ(own.back(), 65536u);
        }
    }
}

// Beyond the outer row of triangles, nothing depends on the outer factors but where the numbering begins.
TEST_P(EdgeProperty, InnerTrianglesIgnoreOuterFactors) {
    std::mt19937 random(6);
    for (int i = 0; i < 100; ++i) {
        const float inside = 2.0f + std::uniform_real_distribution<float>(0.0f, 62.0f)(random);
        std::vector<PatchFactors> factors;
        for (int k = 0; k < 4; ++k) {
            factors.push_back({random_factor(random), random_factor(random), random_factor(random), inside, 0, 0});
        }
        const std::vector<Pattern> patterns = make(GetParam(), factors);
        const std::uint32_t n = test::expected_points(inside, GetParam(), true, true);
        std::vector<std::uint32_t> expected;
        for (std::size_t k = 0; k < patterns.size(); ++k) {
            const std::uint32_t outer = test::outer_point_count(GetParam(), factors[k]);
            const std::size_t row = outer + 3 * (n - 3);
            std::vector<std::uint32_t> inner;
            for (std::size_t p = outer; p < patterns[k].points.size(); ++p) {
                inner.insert(inner.end(), {patterns[k].points[p].u, patterns[k].points[p].v});
            }
            for (std::size_t t = 3 * row; t < patterns[k].indices.size(); ++t) {
                inner.push_back(patterns[k].indices[t] - outer);
            }
            expected = k == 0 ? inner : expected;
            EXPECT_EQ(inner, expected) << test::describe(GetParam(), factors[k]);
        }
    }
}

TEST_P(PatternProperty, CounterClockwiseSwapsTheLastTwoIndices) {
    const std::vector<PatchFactors> factors = random_factors(9, 100);
    const std::vector<Pattern> cw = make(GetParam(), factors);
    const std::vector<Pattern> ccw =
        make_patterns(test::open_device("reference"), Domain::triangle, GetParam(), false, factors);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        ASSERT_EQ(cw[i].indices.size(), ccw[i].indices.size());
        for (std::size_t t = 0; t < cw[i].indices.size(); t += 3) {
            ASSERT_EQ(cw[i].indices[t], ccw[i].indices[t]);
            ASSERT_EQ(cw[i].indices[t + 1], ccw[i].indices[t + 2]);
            ASSERT_EQ(cw[i].indices[t + 2], ccw[i].indices[t + 1]);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Of, PatternProperty, testing::ValuesIn(partitionings),
                         [](const auto& info) { return std::string(name(info.param)); });

INSTANTIATE_TEST_SUITE_P(Of, EdgeProperty, testing::ValuesIn(std::span(partitionings).first(4)),
                         [](const auto& info) { return std::string(name(info.param)); });

// In the fractional modes slivers turn over only just above the factors where points are born.
TEST(PatternProperty, FractionalTrianglesFaceForwardsAwayFromThresholds) {
    std::mt19937 random(13);
    for (const auto& [partitioning, first] :
         {std::pair{Partitioning::fractional_odd, 1.0f}, std::pair{Partitioning::fractional_even, 2.0f}}) {
        const auto factor = [&, start = first] {
            return start + 2.0f * static_cast<float>(random() % 31) +
                   std::uniform_real_distribution<float>(0.05f, 2.0f)(random);
        };
        std::vector<PatchFactors> factors(500);
        for (PatchFactors& f : factors)
            f = {factor(), factor(), factor(), factor(), 0, 0};
        const std::vector<Pattern> patterns = make(partitioning, factors);
        for (std::size_t i = 0; i < patterns.size(); ++i) {
            EXPECT_EQ(test::inverted_or_empty(patterns[i]), 0u) << test::describe(partitioning, factors[i]);
        }
    }
}

}  // namespace
}  // namespace tessera
