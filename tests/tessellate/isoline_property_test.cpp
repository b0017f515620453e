// The invariants of the isoline domain over random factors.
#include "support/devices.hpp"
#include "tessellate/factor_generators.hpp"
#include "tessellate/pattern_checks.hpp"

#include <fmt/format.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tessera {
namespace {

using test::random_factor;

constexpr Partitioning partitionings[] = {Partitioning::integer, Partitioning::pow2, Partitioning::fractional_odd,
                                          Partitioning::fractional_even};

std::vector<Pattern> make(Partitioning partitioning, const std::vector<PatchFactors>& factors, bool clockwise = true) {
    return make_patterns(test::open_device("reference"), Domain::isoline, partitioning, clockwise, factors);
}

/// Where the points of an edge with this factor lie: as on the bottom edge of a triangle.
std::vector<std::uint32_t> edge_places(Partitioning partitioning, float factor) {
    const PatchFactors factors{5, factor, 5, 5, 0, 0};
    const Pattern pattern = make_patterns(test::open_device("reference"), Domain::triangle, partitioning, true,
                                          std::vector<PatchFactors>{factors})
                                .front();
    return test::outer_edge(partitioning, factors, pattern, 1);
}

/// Empty, or what is wrong: lines at the places of the density (an integer in every partitioning), none at v = 1, each
/// with its points at the places of the detail, and segments from point to point within each line.
std::string check(Partitioning partitioning, const PatchFactors& factors, const Pattern& pattern) {
    const auto problem = [&](const std::string& what) {
        return fmt::format("{} density {} detail {}: {}", name(partitioning), factors[0], factors[1], what);
    };
    const std::vector<std::uint32_t> lines = edge_places(Partitioning::integer, factors[0]);
    const std::vector<std::uint32_t> places = edge_places(partitioning, factors[1]);
    if (pattern.points.size() != (lines.size() - 1) * places.size()) {
        return problem(
            fmt::format("{} points instead of {} x {}", pattern.points.size(), lines.size() - 1, places.size()));
    }
    for (std::size_t line = 0; line + 1 < lines.size(); ++line) {
        std::vector<std::uint32_t> found;
        for (std::size_t k = 0; k < places.size(); ++k) {
            const DomainPoint& p = pattern.points[line * places.size() + k];
            if (p.v != lines[line] || p.v == 65536) return problem(fmt::format("point {} is {},{}", k, p.u, p.v));
            found.push_back(p.u);
        }
        // In order of size as places are: just above an even number the rounding of the specification puts the point
        // before the middle a few units behind it.
        std::ranges::sort(found);
        if (found != places) return problem(fmt::format("line {} has other places than the edge", line));
    }
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < pattern.points.size(); ++i) {
        if ((i + 1) % places.size() != 0) expected.insert(expected.end(), {i, i + 1});
    }
    return pattern.indices == expected ? "" : problem("the segments do not follow the lines");
}

std::string check_random(Partitioning partitioning, std::uint32_t seed, std::size_t count) {
    std::mt19937 random(seed);
    std::vector<PatchFactors> factors(count);
    for (PatchFactors& f : factors)
        f = {random_factor(random), random_factor(random), 0, 0, 0, 0};
    const std::vector<Pattern> patterns = make(partitioning, factors);
    for (std::size_t i = 0; i < count; ++i) {
        const std::string problem = check(partitioning, factors[i], patterns[i]);
        if (!problem.empty()) return problem;
    }
    return {};
}

class IsolineProperty : public testing::TestWithParam<Partitioning> {};

TEST_P(IsolineProperty, HoldsForBoundaryValues) {
    std::vector<PatchFactors> factors;
    const std::vector<float> values{1e-40f, 1.0f, 0x1.0000a2p0f, 1.5f, 2.0f, 2.00001f, 3.0f, 63.5f, 64.0f, 1e30f};
    for (const float density : values)
        for (const float detail : values)
            factors.push_back({density, detail, 0, 0, 0, 0});
    const std::vector<Pattern> patterns = make(GetParam(), factors);
    for (std::size_t i = 0; i < factors.size(); ++i)
        EXPECT_EQ(check(GetParam(), factors[i], patterns[i]), "");
}

TEST_P(IsolineProperty, HoldsForAFixedSeed) {
    EXPECT_EQ(check_random(GetParam(), 42, 150), "");
}

TEST_P(IsolineProperty, HoldsForFreshSeeds) {
    EXPECT_TRUE(rc::check([] { RC_ASSERT(check_random(GetParam(), *rc::gen::arbitrary<std::uint32_t>(), 1) == ""); }));
}

TEST_P(IsolineProperty, NumbersOfLinesAreThoseOfTheSpecification) {
    for (std::uint32_t n = 1; n <= 64; ++n) {
        const float density = static_cast<float>(n) - 0.25f;
        const Pattern pattern = make(GetParam(), {{density, 7.5f, 0, 0, 0, 0}}).front();
        const std::uint32_t points = test::expected_points(7.5f, GetParam(), false, false);
        EXPECT_EQ(pattern.points.size(), n * points) << n;
        EXPECT_EQ(pattern.indices.size(), 2 * n * (points - 1)) << n;
    }
}

TEST_P(IsolineProperty, LinesHaveNoWinding) {
    const std::vector<PatchFactors> factors{{3, 4.5f, 0, 0, 0, 0}, {1, 1, 0, 0, 0, 0}};
    const std::vector<Pattern> one = make(GetParam(), factors);
    const std::vector<Pattern> other = make(GetParam(), factors, false);
    for (std::size_t i = 0; i < factors.size(); ++i)
        EXPECT_EQ(one[i].indices, other[i].indices);
}

TEST_P(IsolineProperty, BothFactorsDiscardThePatch) {
    const float not_a_number = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {0.0f, -0.0f, -3.0f, not_a_number}) {
        for (const PatchFactors& f : {PatchFactors{bad, 3, 0, 0, 0, 0}, PatchFactors{3, bad, 0, 0, 0, 0}}) {
            const Pattern pattern = make(GetParam(), {f}).front();
            EXPECT_TRUE(pattern.points.empty() && pattern.indices.empty());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Of, IsolineProperty, testing::ValuesIn(partitionings),
                         [](const auto& info) { return std::string(name(info.param)); });

}  // namespace
}  // namespace tessera
