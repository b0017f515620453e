#include "tessellate/quad_checks.hpp"

#include "tessellate/pattern_checks.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace tessera::test {
namespace {

constexpr float just_above_one = 1.0f + 0x1p-17f;

std::int64_t twice_area(const DomainPoint& a, const DomainPoint& b, const DomainPoint& c) {
    const auto [ax, ay] = std::pair<std::int64_t, std::int64_t>(a.u, a.v);
    return (b.u - ax) * (c.v - ay) - (c.u - ax) * (b.v - ay);
}

/// Places run backwards by no more than this, and that only in the fractional modes, just above a threshold.
constexpr std::int64_t backwards = 7;

/// How far along the boundary a point lies, from (0, 1) down and around; once around the same point is `last`.
/// Negative inside.
std::int64_t along_boundary(const DomainPoint& p, bool last) {
    if (last && p.u == 0 && p.v == 65536) return 262144;
    if (p.u == 0 && p.v > 0) return 65536 - std::int64_t{p.v};
    if (p.v == 0 && p.u < 65536) return 65536 + std::int64_t{p.u};
    if (p.u == 65536 && p.v < 65536) return 131072 + std::int64_t{p.v};
    if (p.v == 65536) return 196608 + 65536 - std::int64_t{p.u};
    return -1;
}

}  // namespace

std::string describe_quad(Partitioning partitioning, const PatchFactors& f) {
    return fmt::format("{} {} {} {} {} inside {} {}", name(partitioning), f[0], f[1], f[2], f[3], f[4], f[5]);
}

std::uint32_t QuadShape::outer_points() const {
    return single ? 4 : edge_points[0] + edge_points[1] + edge_points[2] + edge_points[3] - 4;
}
std::uint32_t QuadShape::points() const {
    return single ? 4 : outer_points() + (inside_u - 2) * (inside_v - 2);
}
std::uint32_t QuadShape::inner_triangles() const {
    return single ? 0 : 2 * (inside_u - 3) * (inside_v - 3);
}
std::uint32_t QuadShape::triangles() const {
    return single ? 2 : outer_points() + inner_triangles() + 2 * (inside_u - 3) + 2 * (inside_v - 3);
}

QuadShape quad_shape(Partitioning partitioning, const PatchFactors& f) {
    QuadShape shape;
    const bool odd = partitioning == Partitioning::fractional_odd;
    const float one = odd ? just_above_one : 1.0f;
    // A NaN among the inside factors counts as the lower bound.
    bool splits = false;
    for (std::size_t i = 0; i < 6; ++i)
        splits = splits || f[i] > one;
    shape.single = !splits && partitioning != Partitioning::fractional_even;
    for (std::size_t i = 0; i < 4; ++i)
        shape.edge_points[i] = expected_points(f[i], partitioning, false, false);
    shape.inside_u = expected_points(f[4], partitioning, true, splits);
    shape.inside_v = expected_points(f[5], partitioning, true, splits);
    return shape;
}

std::string check_quad_pattern(Partitioning partitioning, const PatchFactors& factors, const Pattern& pattern) {
    const auto problem = [&](const std::string& what) {
        return fmt::format("{}: {}", describe_quad(partitioning, factors), what);
    };
    const QuadShape shape = quad_shape(partitioning, factors);
    if (pattern.points.size() != shape.points() || pattern.indices.size() != 3 * shape.triangles()) {
        return problem(fmt::format("{} points and {} triangles instead of {} and {}", pattern.points.size(),
                                   pattern.indices.size() / 3, shape.points(), shape.triangles()));
    }
    std::vector<bool> used(pattern.points.size());
    std::vector<std::uint32_t> edges;  // from << 16 | to; a pattern has at most 4225 points
    std::int64_t area = 0;
    for (std::size_t t = 0; t < pattern.indices.size(); t += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = pattern.indices[t + k];
            if (from >= pattern.points.size()) return problem(fmt::format("triangle {} uses point {}", t / 3, from));
            used[from] = true;
            edges.push_back(from << 16 | pattern.indices[t + (k + 1) % 3]);
        }
        area += twice_area(pattern.points[pattern.indices[t]], pattern.points[pattern.indices[t + 1]],
                           pattern.points[pattern.indices[t + 2]]);
    }
    if (std::ranges::find(used, false) != used.end()) return problem("a point is not used");
    if (area != 2 * std::int64_t{65536} * 65536) return problem(fmt::format("twice the area is {}", area));
    std::ranges::sort(edges);
    if (std::ranges::adjacent_find(edges) != edges.end()) return problem("a directed edge comes twice");

    const std::uint32_t ring = shape.outer_points();
    std::vector<std::uint32_t> expected;
    std::int64_t before = 0;
    for (std::uint32_t i = 0; i < pattern.points.size(); ++i) {
        const DomainPoint& p = pattern.points[i];
        if (p.u > 65536 || p.v > 65536) return problem(fmt::format("point {},{} lies outside", p.u, p.v));
        if (i >= ring) continue;
        const std::int64_t place = along_boundary(p, before > 65536);
        if (place < 0) return problem(fmt::format("point {} of the outer ring is {},{}", i, p.u, p.v));
        // The corners of the single quad are listed from (0, 0).
        if (!shape.single && place + backwards < before) {
            return problem(fmt::format("the outer ring turns back at point {}", i));
        }
        before = place;
        expected.push_back(i << 16 | (i + 1) % ring);
    }
    std::vector<std::uint32_t> open;
    for (const std::uint32_t edge : edges) {
        if (!std::ranges::binary_search(edges, edge >> 16 | edge << 16)) open.push_back(edge);
    }
    std::ranges::sort(expected);
    if (open != expected) return problem(fmt::format("{} open edges are not the outer segments", open.size()));
    return {};
}

std::vector<std::uint32_t> quad_edge(Partitioning partitioning, const PatchFactors& factors, const Pattern& pattern,
                                     std::size_t edge) {
    const QuadShape shape = quad_shape(partitioning, factors);
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < edge; ++i)
        first += shape.edge_points[i] - 1;
    std::vector<std::uint32_t> coordinates;
    for (std::uint32_t i = 0; i < shape.edge_points[edge]; ++i) {
        const DomainPoint& p = pattern.points[(first + i) % shape.outer_points()];
        coordinates.push_back(edge % 2 == 0 ? p.v : p.u);
    }
    std::ranges::sort(coordinates);
    return coordinates;
}

}  // namespace tessera::test
