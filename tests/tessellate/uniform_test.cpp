// The even triangular grid: one level for a patch, the same points on every edge from either side.
#include "support/devices.hpp"
#include "tessellate/pattern_checks.hpp"

#include <algorithm>
#include <cstdlib>

namespace tessera {
namespace {

TEST(UniformPattern, EveryLevel) {
    std::vector<PatchFactors> factors;
    for (int n = 1; n <= 64; ++n) {
        const auto f = static_cast<float>(n);
        factors.push_back({f, f, f, f, 0, 0});
    }
    const std::vector<Pattern> patterns =
        make_patterns(test::open_device("reference"), Domain::triangle, Partitioning::uniform, true, factors);
    for (std::uint32_t n = 1; n <= 64; ++n) {
        SCOPED_TRACE(n);
        const Pattern& pattern = patterns[n - 1];
        EXPECT_EQ(pattern.points.size(), (n + 1) * (n + 2) / 2);
        EXPECT_EQ(pattern.indices.size(), 3 * n * n);
        EXPECT_EQ(test::check_triangle_pattern(Partitioning::uniform, factors[n - 1], pattern), "");
        EXPECT_EQ(test::inverted_or_empty(pattern), 0u);
        std::vector<std::uint32_t> edges[3];
        for (const DomainPoint& p : pattern.points) {
            if (p.u == 0) edges[0].push_back(p.v);
            if (p.v == 0) edges[1].push_back(p.u);
            if (p.u + p.v == 65536) edges[2].push_back(p.u);
        }
        for (auto& edge : edges) {
            std::ranges::sort(edge);
            ASSERT_EQ(edge.size(), n + 1);
            EXPECT_EQ(edge, edges[0]);
            for (std::uint32_t i = 0; i <= n; ++i) {
                EXPECT_EQ(edge[i], 65536 - edge[n - i]);
                EXPECT_LE(std::abs(static_cast<double>(edge[i]) - 65536.0 * i / n), 0.5);
            }
        }
        // Inside, every point lies within a unit of the exact grid.
        std::size_t at = 0;
        for (std::uint32_t y = 0; y <= n; ++y) {
            for (std::uint32_t x = 0; x + y <= n; ++x, ++at) {
                EXPECT_LE(std::abs(static_cast<double>(pattern.points[at].u) - 65536.0 * x / n), 0.5);
                EXPECT_LE(std::abs(static_cast<double>(pattern.points[at].v) - 65536.0 * y / n), 0.5);
            }
        }
    }
}

TEST(UniformPattern, TakesTheLargestFactor) {
    for (std::size_t i = 0; i < 4; ++i) {
        PatchFactors factors{2, 2, 2, 2, 60, 60};
        factors[i] = 6.5f;
        const std::vector<Pattern> patterns = make_patterns(test::open_device("reference"), Domain::triangle,
                                                            Partitioning::uniform, true, std::span(&factors, 1));
        EXPECT_EQ(patterns[0].indices.size(), 3u * 49u) << "factor " << i;
    }
}

}  // namespace
}  // namespace tessera
