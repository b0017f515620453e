// Factors that are not ordinary numbers, on every device: some devices flush denormals and treat NaN as they like.
#include "support/devices.hpp"
#include "tessellate/edge_factors.hpp"
#include "tessellate/pattern_checks.hpp"

#include "patches/patches.hpp"
#include "scene/shapes.hpp"

#include <bit>
#include <limits>
#include <map>
#include <set>

namespace tessera {
namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float denormal = std::numeric_limits<float>::denorm_min();
constexpr Partitioning partitionings[] = {Partitioning::integer, Partitioning::pow2, Partitioning::fractional_odd,
                                          Partitioning::fractional_even, Partitioning::uniform};

class Factors : public testing::TestWithParam<gpu::DeviceInfo> {
protected:
    std::vector<Pattern> make(Partitioning partitioning, const std::vector<PatchFactors>& factors) {
        return make_patterns(test::open_device(GetParam().id), Domain::triangle, partitioning, true, factors);
    }
    static void expect_equal(const Pattern& a, const Pattern& b, const std::string& what) {
        EXPECT_EQ(a.indices, b.indices) << what;
        ASSERT_EQ(a.points.size(), b.points.size()) << what;
        for (std::size_t i = 0; i < a.points.size(); ++i) {
            EXPECT_EQ(a.points[i].u, b.points[i].u) << what;
            EXPECT_EQ(a.points[i].v, b.points[i].v) << what;
        }
    }
};

TEST_P(Factors, OuterFactorsThatAreNotPositiveCull) {
    std::vector<PatchFactors> factors;
    const float bad[] = {0.0f,      -0.0f,     -1.0f,      -denormal,
                         -infinity, nan_value, -nan_value, std::bit_cast<float>(0x7f800001u)};
    for (const float factor : bad) {
        for (std::size_t edge = 0; edge < 3; ++edge) {
            factors.push_back({3, 4, 5, 6, 0, 0});
            factors.back()[edge] = factor;
        }
    }
    for (const Partitioning partitioning : partitionings) {
        const std::vector<Pattern> patterns = make(partitioning, factors);
        for (std::size_t i = 0; i < factors.size(); ++i) {
            EXPECT_TRUE(patterns[i].points.empty() && patterns[i].indices.empty())
                << test::describe(partitioning, factors[i]);
        }
    }
}

TEST_P(Factors, OutOfRangeFactorsAreClamped) {
    for (const Partitioning partitioning : partitionings) {
        const float highest = partitioning == Partitioning::fractional_odd ? 63.0f : 64.0f;
        const float lowest = partitioning == Partitioning::fractional_even ? 2.0f : 1.0f;
        const std::vector<PatchFactors> given{
            {denormal, 3, 4, 5, 0, 0},  {0.5f, 3, 4, 5, 0, 0},
            {infinity, 3, 4, 5, 0, 0},  {65.0f, 3, 4, 5, 0, 0},
            {3, 4, 5, nan_value, 0, 0}, {3, 4, 5, -infinity, 0, 0},
            {3, 4, 5, infinity, 0, 0},  {3, 4, 5, 0.0f, 0, 0},
            {3, 4, 5, -7.0f, 0, 0},     {denormal, denormal, denormal, denormal, 0, 0}};
        const std::vector<PatchFactors> meant{{lowest, 3, 4, 5, 0, 0},  {lowest, 3, 4, 5, 0, 0},
                                              {highest, 3, 4, 5, 0, 0}, {highest, 3, 4, 5, 0, 0},
                                              {3, 4, 5, lowest, 0, 0},  {3, 4, 5, lowest, 0, 0},
                                              {3, 4, 5, highest, 0, 0}, {3, 4, 5, lowest, 0, 0},
                                              {3, 4, 5, lowest, 0, 0},  {lowest, lowest, lowest, lowest, 0, 0}};
        const std::vector<Pattern> found = make(partitioning, given);
        const std::vector<Pattern> expected = make(partitioning, meant);
        for (std::size_t i = 0; i < given.size(); ++i) {
            EXPECT_FALSE(expected[i].points.empty());
            expect_equal(found[i], expected[i], test::describe(partitioning, given[i]));
        }
    }
}

TEST_P(Factors, UnusedFactorsDoNotMatter) {
    for (const Partitioning partitioning : partitionings) {
        const std::vector<Pattern> patterns = make(partitioning, {{3, 4, 5, 6, 0, 0}, {3, 4, 5, 6, nan_value, 99}});
        expect_equal(patterns[0], patterns[1], std::string(name(partitioning)));
    }
}

TEST_P(Factors, IntegersAreRoundedUp) {
    for (const Partitioning partitioning : {Partitioning::integer, Partitioning::pow2, Partitioning::uniform}) {
        const std::vector<Pattern> patterns =
            make(partitioning, {{3, 4, 5, 6, 0, 0}, {2.0000002f, 3.5f, 4.25f, 5.9f, 0, 0}});
        expect_equal(patterns[0], patterns[1], std::string(name(partitioning)));
    }
}

TEST_P(Factors, CulledPatchesBetweenOthersTakeNoRoom) {
    const std::vector<PatchFactors> factors{{0, 1, 1, 1, 0, 0},  {3, 4, 5, 6, 0, 0}, {1, nan_value, 1, 1, 0, 0},
                                            {-1, 1, 1, 1, 0, 0}, {7, 2, 3, 4, 0, 0}, {1, 1, 0, 1, 0, 0}};
    const std::vector<Pattern> all = make(Partitioning::fractional_odd, factors);
    const std::vector<Pattern> alone = make(Partitioning::fractional_odd, {factors[1], factors[4]});
    expect_equal(all[1], alone[0], "second patch");
    expect_equal(all[4], alone[1], "fifth patch");
    for (const std::size_t i : {0u, 2u, 3u, 5u}) {
        EXPECT_TRUE(all[i].points.empty());
    }
}

TEST_P(Factors, NoPatternsOfNoFactors) {
    EXPECT_TRUE(make(Partitioning::integer, {}).empty());
}

TEST_P(Factors, AllCulled) {
    const std::vector<Pattern> patterns = make(Partitioning::integer, {{0, 0, 0, 0, 0, 0}, {-1, 1, 1, 1, 0, 0}});
    ASSERT_EQ(patterns.size(), 2u);
    EXPECT_TRUE(patterns[0].indices.empty() && patterns[1].indices.empty());
}

TESSERA_ON_EVERY_DEVICE(Factors);

TEST(EdgeFactors, AgreeAcrossSharedEdgesAndDifferElsewhere) {
    const patches::PatchSet set = patches::make_patches(scene::make_shape("shape:torus"));
    const std::vector<PatchFactors> factors = random_edge_factors(set, 2.0f, 9.0f, 7);
    ASSERT_EQ(factors.size(), set.patch_count());
    std::map<std::vector<float>, std::vector<float>> by_edge;  // ends in canonical order -> the factors of its patches
    for (std::size_t p = 0; p < factors.size(); ++p) {
        const auto position = [&](std::size_t k) {
            const Vertex& v = set.control_vertices[set.corners[p][k % 3]];
            return std::vector<float>(v.position, v.position + 3);
        };
        for (std::size_t edge = 0; edge < 3; ++edge) {
            // Edge i is opposite to corner i.
            std::vector<float> a = position(edge + 1);
            std::vector<float> b = position(edge + 2);
            if (b < a) std::swap(a, b);
            a.insert(a.end(), b.begin(), b.end());
            by_edge[a].push_back(factors[p][edge]);
            EXPECT_GE(factors[p][edge], 2.0f);
            EXPECT_LE(factors[p][edge], 9.0f);
        }
    }
    std::set<float> distinct;
    for (const auto& [edge, values] : by_edge) {
        ASSERT_EQ(values.size(), 2u);
        EXPECT_EQ(values[0], values[1]);
        distinct.insert(values[0]);
    }
    EXPECT_GT(distinct.size(), by_edge.size() * 9 / 10);
    EXPECT_EQ(random_edge_factors(set, 2.0f, 9.0f, 7), factors);
    EXPECT_NE(random_edge_factors(set, 2.0f, 9.0f, 8), factors);
}

}  // namespace
}  // namespace tessera
