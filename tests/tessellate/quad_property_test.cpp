// The invariants of the quad domain, and the rules of the Vulkan conformance suite, over random factors and every
// combination of those at which something changes.
#include "support/devices.hpp"
#include "tessellate/factor_generators.hpp"
#include "tessellate/pattern_checks.hpp"
#include "tessellate/quad_checks.hpp"

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace tessera {
namespace {

using test::describe_quad;
using test::random_factor;

constexpr Partitioning partitionings[] = {Partitioning::integer, Partitioning::pow2, Partitioning::fractional_odd,
                                          Partitioning::fractional_even};

std::vector<Pattern> make(Partitioning partitioning, const std::vector<PatchFactors>& factors,
                          Domain domain = Domain::quad, bool clockwise = true) {
    return make_patterns(test::open_device("reference"), domain, partitioning, clockwise, factors);
}

/// The first problem of many patterns, or nothing.
std::string check_all(Partitioning partitioning, const std::vector<PatchFactors>& factors) {
    const std::vector<Pattern> patterns = make(partitioning, factors);
    const bool integer = partitioning == Partitioning::integer || partitioning == Partitioning::pow2;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const std::string problem = test::check_quad_pattern(partitioning, factors[i], patterns[i]);
        if (!problem.empty()) return problem;
        if (integer && test::inverted_or_empty(patterns[i]) > 0) {
            return describe_quad(partitioning, factors[i]) + ": a triangle is inverted or has no area";
        }
    }
    return {};
}

std::vector<PatchFactors> random_factors(std::uint32_t seed, std::size_t count) {
    std::mt19937 random(seed);
    std::vector<PatchFactors> factors(count);
    for (PatchFactors& f : factors)
        std::ranges::generate(f, [&] { return random_factor(random); });
    return factors;
}

/// Sets of six where each is one of these: all of them where two outer factors and both inside ones vary.
std::vector<PatchFactors> combinations(const std::vector<float>& values) {
    std::vector<PatchFactors> factors;
    std::mt19937 random(3);
    const auto any = [&] { return values[random() % values.size()]; };
    for (const float a : values)
        for (const float b : values)
            for (const float u : values)
                for (const float v : values) {
                    PatchFactors f{any(), any(), any(), any(), u, v};
                    const std::size_t edge = random() % 4;
                    f[edge] = a;
                    f[(edge + 1) % 4] = b;
                    factors.push_back(f);
                }
    return factors;
}

/// Triangles as sets of three domain points, turned so that the least comes first: equal for equal triangles in equal
/// winding.
using TriangleSet = std::multiset<std::array<std::uint64_t, 3>>;

TriangleSet triangle_set(const Pattern& pattern, std::size_t first = 0) {
    TriangleSet set;
    for (std::size_t t = 3 * first; t < pattern.indices.size(); t += 3) {
        std::array<std::uint64_t, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            const DomainPoint& p = pattern.points[pattern.indices[t + k]];
            corners[k] = std::uint64_t{p.u} << 32 | p.v;
        }
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        set.insert(corners);
    }
    return set;
}

class QuadProperty : public testing::TestWithParam<Partitioning> {};

TEST_P(QuadProperty, HoldsForCombinationsOfIntegers) {
    EXPECT_EQ(check_all(GetParam(), combinations({1, 2, 3, 4, 7, 8, 64})), "");
}

TEST_P(QuadProperty, HoldsForCombinationsOfBoundaryValues) {
    const float not_a_number = std::numeric_limits<float>::quiet_NaN();
    std::vector<PatchFactors> factors =
        combinations({1e-40f, 1.0f, 0x1.00008p0f, 0x1.0000a2p0f, 0x1.0001p0f, 2.0f, 2.00001f, 3.00001f, 1e30f});
    EXPECT_EQ(check_all(GetParam(), factors), "");
    for (PatchFactors& f : factors)
        f[4 + (f[0] > 1.0f ? 1 : 0)] = not_a_number;
    EXPECT_EQ(check_all(GetParam(), factors), "");
}

TEST_P(QuadProperty, HoldsForAFixedSeed) {
    EXPECT_EQ(check_all(GetParam(), random_factors(42, 1000)), "");
}

TEST_P(QuadProperty, HoldsForFreshSeeds) {
    EXPECT_TRUE(rc::check([] {
        const auto seed = *rc::gen::arbitrary<std::uint32_t>();
        RC_ASSERT(check_all(GetParam(), random_factors(seed, 10)) == "");
    }));
}

// Edge division depends on the edge's factor only, is the same on every edge of either domain, and symmetric: all that
// a neighbour relies on.
TEST_P(QuadProperty, OuterPointsDependOnTheirOwnFactorOnlyAndAreThoseOfTriangles) {
    std::mt19937 random(5);
    std::vector<PatchFactors> quads;
    std::vector<PatchFactors> triangles;
    std::vector<float> shared;
    const auto above_one = [&] { return 1.5f + random_factor(random); };
    for (int i = 0; i < 300; ++i) {
        shared.push_back(random_factor(random));
        for (std::size_t edge = 0; edge < 4; ++edge) {
            PatchFactors f{above_one(), above_one(), above_one(), above_one(), above_one(), above_one()};
            f[edge] = shared.back();
            quads.push_back(f);
        }
        triangles.push_back({above_one(), shared.back(), above_one(), above_one(), 0, 0});
    }
    const std::vector<Pattern> patterns = make(GetParam(), quads);
    const std::vector<Pattern> beside = make(GetParam(), triangles, Domain::triangle);
    for (std::size_t i = 0; i < shared.size(); ++i) {
        const std::vector<std::uint32_t> neighbour = test::outer_edge(GetParam(), triangles[i], beside[i], 1);
        for (std::size_t edge = 0; edge < 4; ++edge) {
            const std::size_t at = 4 * i + edge;
            const std::vector<std::uint32_t> own = test::quad_edge(GetParam(), quads[at], patterns[at], edge);
            EXPECT_EQ(own, neighbour) << describe_quad(GetParam(), quads[at]) << " edge " << edge;
            EXPECT_EQ(own.front(), 0u);
            EXPECT_EQ(own.back(), 65536u);
            for (std::size_t k = 0; k < own.size(); ++k)
                ASSERT_EQ(own[k], 65536 - own[own.size() - 1 - k]) << describe_quad(GetParam(), quads[at]);
        }
    }
}

// Of the segments of an edge all are equally long but two, which are not longer and lie as mirror images.
TEST_P(QuadProperty, SpacingIsThatOfThePartitioning) {
    std::mt19937 random(8);
    // Reciprocals are rounded to 1/65536, and the middle point takes up what has added up until there.
    constexpr int rounding = 40;
    for (const PatchFactors& f : random_factors(7, 300)) {
        PatchFactors factors = f;
        factors[4] = factors[5] = 5.0f;
        const Pattern pattern = make(GetParam(), {factors}).front();
        const std::vector<std::uint32_t> edge = test::quad_edge(GetParam(), factors, pattern, 1);
        std::vector<int> lengths;
        for (std::size_t i = 1; i < edge.size(); ++i)
            lengths.push_back(static_cast<int>(edge[i] - edge[i - 1]));
        const int longest = *std::ranges::max_element(lengths);
        const auto is_short = [&](int length) { return length < longest - rounding; };
        EXPECT_LE(std::ranges::count_if(lengths, is_short), 2) << describe_quad(GetParam(), factors);
        if (GetParam() == Partitioning::integer || GetParam() == Partitioning::pow2) {
            EXPECT_EQ(std::ranges::count_if(lengths, is_short), 0) << describe_quad(GetParam(), factors);
        }
        for (std::size_t i = 0; i < lengths.size(); ++i)
            EXPECT_EQ(is_short(lengths[i]), is_short(lengths[lengths.size() - 1 - i]));
    }
}

// The triangles that touch no outer point are the same whatever the outer factors, in the same order.
TEST_P(QuadProperty, InnerTrianglesIgnoreOuterFactors) {
    std::mt19937 random(6);
    for (int i = 0; i < 100; ++i) {
        std::uniform_real_distribution<float> inside(2.0f, 64.0f);
        const float u = inside(random);
        const float v = inside(random);
        std::vector<PatchFactors> factors;
        for (int k = 0; k < 4; ++k)
            factors.push_back(
                {random_factor(random), random_factor(random), random_factor(random), random_factor(random), u, v});
        const std::vector<Pattern> patterns = make(GetParam(), factors);
        TriangleSet expected;
        for (std::size_t k = 0; k < patterns.size(); ++k) {
            const test::QuadShape shape = test::quad_shape(GetParam(), factors[k]);
            const std::size_t outer = shape.triangles() - shape.inner_triangles();
            for (std::size_t t = 0; t < patterns[k].indices.size(); t += 3) {
                const auto touches = [&](std::uint32_t index) { return index < shape.outer_points(); };
                const bool any = std::any_of(patterns[k].indices.begin() + static_cast<std::ptrdiff_t>(t),
                                             patterns[k].indices.begin() + static_cast<std::ptrdiff_t>(t) + 3, touches);
                ASSERT_EQ(any, t < 3 * outer) << describe_quad(GetParam(), factors[k]) << " triangle " << t / 3;
            }
            const TriangleSet inner = triangle_set(patterns[k], outer);
            expected = k == 0 ? inner : expected;
            EXPECT_EQ(inner, expected) << describe_quad(GetParam(), factors[k]);
        }
    }
}

// The outer triangles along one edge depend on that edge's factor and the inside factors only.
TEST_P(QuadProperty, OuterTrianglesAlongAnEdgeDependOnItsFactorOnly) {
    std::mt19937 random(16);
    const auto above_two = [&] { return 2.0f + random_factor(random); };
    for (int i = 0; i < 60; ++i) {
        const float own = random_factor(random);
        const float u = above_two();
        const float v = above_two();
        const std::size_t edge = random() % 4;
        TriangleSet expected;
        for (int k = 0; k < 3; ++k) {
            PatchFactors f{above_two(), above_two(), above_two(), above_two(), u, v};
            f[edge] = own;
            const Pattern pattern = make(GetParam(), {f}).front();
            const test::QuadShape shape = test::quad_shape(GetParam(), f);
            std::size_t before = 0;  // triangles of the edges before: segments outside and inside
            const auto in_strip = [&](std::size_t e) {
                return shape.edge_points[e] - 1 + (e % 2 == 0 ? shape.inside_v : shape.inside_u) - 3;
            };
            for (std::size_t e = 0; e < edge; ++e)
                before += in_strip(e);
            Pattern strip = pattern;
            strip.indices.resize(3 * (before + in_strip(edge)));
            const TriangleSet found = triangle_set(strip, before);
            expected = k == 0 ? found : expected;
            EXPECT_EQ(found, expected) << describe_quad(GetParam(), f) << " edge " << edge;
        }
    }
}

TEST_P(QuadProperty, CounterClockwiseIsTheSameSetTurnedOver) {
    const std::vector<PatchFactors> factors = random_factors(9, 60);
    const std::vector<Pattern> cw = make(GetParam(), factors);
    const std::vector<Pattern> ccw = make(GetParam(), factors, Domain::quad, false);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        ASSERT_EQ(cw[i].indices.size(), ccw[i].indices.size());
        Pattern turned = ccw[i];
        for (std::size_t t = 0; t < turned.indices.size(); t += 3)
            std::swap(turned.indices[t + 1], turned.indices[t + 2]);
        ASSERT_EQ(turned.indices, cw[i].indices);
        ASSERT_EQ(triangle_set(turned), triangle_set(cw[i]));
        ASSERT_NE(ccw[i].indices, cw[i].indices);
    }
}

TEST_P(QuadProperty, OuterFactorsThatAreNotPositiveDiscardThePatch) {
    const float not_a_number = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    std::vector<PatchFactors> discarded;
    std::vector<PatchFactors> kept;
    for (const float bad : {0.0f, -0.0f, -3.0f, -infinity, not_a_number}) {
        for (std::size_t i = 0; i < 6; ++i) {
            PatchFactors f{3, 4, 5, 6, 7, 8};
            f[i] = bad;
            (i < 4 ? discarded : kept).push_back(f);
        }
    }
    for (const Pattern& pattern : make(GetParam(), discarded))
        EXPECT_TRUE(pattern.points.empty() && pattern.indices.empty());
    EXPECT_EQ(check_all(GetParam(), kept), "");
}

INSTANTIATE_TEST_SUITE_P(Of, QuadProperty, testing::ValuesIn(partitionings),
                         [](const auto& info) { return std::string(name(info.param)); });

// In the fractional modes slivers turn over only just above the factors where points are born.
TEST(QuadProperty, FractionalTrianglesFaceForwardsAwayFromThresholds) {
    std::mt19937 random(13);
    for (const auto& [partitioning, first] :
         {std::pair{Partitioning::fractional_odd, 1.0f}, std::pair{Partitioning::fractional_even, 2.0f}}) {
        std::vector<PatchFactors> factors(400);
        for (PatchFactors& f : factors) {
            std::ranges::generate(f, [&, start = first] {
                return start + 2.0f * static_cast<float>(random() % 31) +
                       std::uniform_real_distribution<float>(0.05f, 2.0f)(random);
            });
        }
        const std::vector<Pattern> patterns = make(partitioning, factors);
        for (std::size_t i = 0; i < patterns.size(); ++i)
            EXPECT_EQ(test::inverted_or_empty(patterns[i]), 0u) << describe_quad(partitioning, factors[i]);
    }
}

}  // namespace
}  // namespace tessera
