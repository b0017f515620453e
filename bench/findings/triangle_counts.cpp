#include "findings.hpp"

#include "tessellate/pattern.hpp"

#include <fmt/format.h>
#include <span>

namespace tessera::findings {
namespace {

/// Ni, Direct3D 11 Tessellation, GDC 2010, slide "Tessellation Patterns".
std::size_t triangles_of_ni(std::size_t lod) {
    std::size_t sum = 0;
    for (std::size_t i = 1; i <= lod / 2; ++i)
        sum += lod % 2 == 1 ? 2 * i : 2 * i - 1;
    return 6 * sum + lod % 2;
}

}  // namespace

void write_triangle_counts(const Bench& bench, Document& document) {
    std::vector<PatchFactors> factors;
    for (std::size_t n = 1; n <= 64; ++n)
        factors.push_back(equal_factors(static_cast<float>(n)));
    const auto triangles = make_patterns(bench.device, Domain::triangle, Partitioning::integer, true, factors);
    const auto quads = make_patterns(bench.device, Domain::quad, Partitioning::integer, true, factors);
    std::size_t equal = 0;
    for (std::size_t n = 1; n <= 64; ++n) {
        equal += triangles[n - 1].indices.size() / 3 == triangles_of_ni(n) ? 1 : 0;
        equal += quads[n - 1].indices.size() / 3 == 2 * n * n ? 1 : 0;
    }
    document.heading("4. The triangle counts of Ni's slide");
    document.paragraph(
        "Ni (*Direct3D 11 Tessellation*, GDC 2010) gives formulas for the triangles of a pattern whose factors are all "
        "n. Ours, with integer partitioning:");
    document.commands(
        "build/release/findings --only counts\n"
        "build/release/tests/tessellate/test_tessellate --gtest_filter='*TriangleCounts*'");
    Rows table{{"n"}, {"triangles"}, {"quads"}};
    for (const std::size_t n : {1, 2, 3, 4, 5, 8, 9, 16, 32, 63, 64}) {
        table[0].push_back(fmt::to_string(n));
        table[1].push_back(fmt::to_string(triangles[n - 1].indices.size() / 3));
        table[2].push_back(fmt::to_string(quads[n - 1].indices.size() / 3));
    }
    document.table(table);
    document.claim(equal == 128, fmt::format("{} of 128 counts, n = 1 to 64 on triangles and quads, are those of the "
                                             "slide. The test `tests/tessellate/triangle_counts_test.cpp` holds them "
                                             "on every device, with the fractional partitionings.",
                                             equal));
}

}  // namespace tessera::findings
