// Patterns of the kernels against the device's own tessellator: every domain, spacing and winding.
#include "oracle/factor_sets.hpp"
#include "oracle/oracle_suite.hpp"

#include <fmt/format.h>

namespace tessera::test {
namespace {

struct Mode {
    Domain domain;
    Partitioning partitioning;
    bool clockwise;
};

void PrintTo(const Mode& mode, std::ostream* out) {
    *out << name(mode.domain) << " " << name(mode.partitioning) << (mode.clockwise ? " cw" : " ccw");
}

class DomainOracle : public OracleSuite, public testing::WithParamInterface<Mode> {
protected:
    static verify::DomainComparison compare(const std::vector<PatchFactors>& factors) {
        const Mode& mode = GetParam();
        const auto result = verify::compare_domain(stage(), open_device("reference"), mode.domain, mode.partitioning,
                                                   mode.clockwise, factors);
        EXPECT_EQ(result.patches, factors.size());
        return result;
    }
};

TEST_P(DomainOracle, AgreesOnSystematicFactors) {
    const auto result = compare(systematic_factors(GetParam().domain));
    EXPECT_EQ(result.differing, 0u) << result.first.value_or("");
    EXPECT_GT(result.primitives, 1000u);
}

TEST_P(DomainOracle, AgreesOnRandomFactors) {
    const Mode& mode = GetParam();
    const std::uint64_t seed = 100 + static_cast<std::uint64_t>(mode.domain) * 16 +
                               static_cast<std::uint64_t>(mode.partitioning) * 2 + (mode.clockwise ? 1 : 0);
    const auto result = compare(random_factor_sets(random_set_count(), seed));
    EXPECT_EQ(result.differing, 0u) << result.first.value_or("");
    EXPECT_GT(result.primitives, 1000u);
}

std::vector<Mode> modes() {
    std::vector<Mode> list;
    for (const Domain domain : {Domain::triangle, Domain::quad, Domain::isoline}) {
        for (const auto partitioning :
             {Partitioning::integer, Partitioning::fractional_odd, Partitioning::fractional_even}) {
            for (const bool clockwise : {true, false}) {
                list.push_back({domain, partitioning, clockwise});
            }
        }
    }
    return list;
}

INSTANTIATE_TEST_SUITE_P(Every, DomainOracle, testing::ValuesIn(modes()), [](const auto& mode) {
    return fmt::format("{}_{}_{}", name(mode.param.domain), name(mode.param.partitioning),
                       mode.param.clockwise ? "cw" : "ccw");
});

}  // namespace
}  // namespace tessera::test
