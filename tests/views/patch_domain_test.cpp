// The domains that views work out on the host are those of the devices.
#include "views/patch_domain.hpp"

#include "support/devices.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <random>

namespace tessera {
namespace {

class DomainOf : public testing::TestWithParam<std::tuple<Domain, Partitioning>> {};

TEST_P(DomainOf, RandomFactorsHasThePointsOfTheDevice) {
    const auto [domain, partitioning] = GetParam();
    std::mt19937 random(7);
    std::uniform_real_distribution<float> any(0.3f, 20.0f);
    std::vector<PatchFactors> factors(60);
    for (PatchFactors& set : factors)
        for (float& factor : set)
            factor = any(random);
    factors[0] = {1, 1, 1, 1, 1, 1};
    factors[1] = {5, 0, 3, 2, 2, 2};  // culled
    factors[2] = {64, 64, 64, 64, 64, 64};
    factors[3] = {3, 3, 3, 3, 1, 1};
    const auto patterns = make_patterns(test::open_device("reference"), domain, partitioning, true, factors);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const views::PatchDomain own(domain, partitioning, factors[i]);
        ASSERT_EQ(own.vertex_count(), patterns[i].points.size()) << i;
        ASSERT_EQ(own.index_count(), patterns[i].indices.size()) << i;
        const std::vector<DomainPoint> points = own.points();
        ASSERT_EQ(points.size(), patterns[i].points.size());
        for (std::size_t k = 0; k < points.size(); ++k) {
            ASSERT_EQ(points[k].u, patterns[i].points[k].u) << i << ", " << k;
            ASSERT_EQ(points[k].v, patterns[i].points[k].v) << i << ", " << k;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Every, DomainOf,
                         testing::Combine(testing::Values(Domain::triangle, Domain::quad),
                                          testing::Values(Partitioning::integer, Partitioning::pow2,
                                                          Partitioning::fractional_odd, Partitioning::fractional_even,
                                                          Partitioning::uniform)));

TEST(PatchDomain, TellsFactorsAsTheyAreUsed) {
    const PatchFactors asked{2.5f, 100.0f, 0.5f, 7.25f, 0, 0};
    using views::PatchDomain;
    EXPECT_EQ(PatchDomain(Domain::triangle, Partitioning::fractional_odd, asked).factors(),
              (PatchFactors{2.5f, 63, 1, 7.25f, 0, 0}));
    EXPECT_EQ(PatchDomain(Domain::triangle, Partitioning::fractional_even, asked).factors(),
              (PatchFactors{2.5f, 64, 2, 7.25f, 0, 0}));
    EXPECT_EQ(PatchDomain(Domain::triangle, Partitioning::integer, asked).factors(), (PatchFactors{3, 64, 1, 8, 0, 0}));
    EXPECT_EQ(PatchDomain(Domain::triangle, Partitioning::uniform, asked).factors(),
              (PatchFactors{64, 64, 64, 64, 0, 0}));
    const PatchDomain culled(Domain::quad, Partitioning::integer, {1, 2, std::nanf(""), 4, 5, 6});
    EXPECT_EQ(culled.factors(), PatchFactors{});
    EXPECT_EQ(culled.vertex_count(), 0u);
}

}  // namespace
}  // namespace tessera
