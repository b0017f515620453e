#include "tessellate/pattern_checks.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace tessera::test {
namespace {

bool outer_splits(const PatchFactors& f) {
    return std::max({f[0], f[1], f[2]}) > 1.0f + 0x1p-17f;
}

std::int64_t twice_area(const DomainPoint& a, const DomainPoint& b, const DomainPoint& c) {
    const auto [ax, ay] = std::pair<std::int64_t, std::int64_t>(a.u, a.v);
    return (b.u - ax) * (c.v - ay) - (c.u - ax) * (b.v - ay);
}

// Directed edges as from << 16 | to, sorted; a pattern has at most 3169 points.
std::vector<std::uint32_t> directed_edges(const Pattern& pattern) {
    std::vector<std::uint32_t> edges;
    edges.reserve(pattern.indices.size());
    for (std::size_t t = 0; t < pattern.indices.size(); t += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            edges.push_back(pattern.indices[t + k] << 16 | pattern.indices[t + (k + 1) % 3]);
        }
    }
    std::ranges::sort(edges);
    return edges;
}

std::string check_counts(Partitioning partitioning, const PatchFactors& factors, const Pattern& pattern) {
    std::size_t points = 3;
    std::size_t triangles = 1;
    if (partitioning == Partitioning::uniform) {
        const float greatest = std::max({factors[0], factors[1], factors[2], factors[3], 1.0f});
        const auto n = static_cast<std::size_t>(std::ceil(std::min(greatest, 64.0f)));
        points = (n + 1) * (n + 2) / 2;
        triangles = n * n;
    } else if (!is_single(partitioning, factors)) {
        const std::size_t s = outer_point_count(partitioning, factors);
        const std::size_t n = expected_points(factors[3], partitioning, true, outer_splits(factors));
        const std::size_t r = n / 2 - 1;
        points = s + (n % 2 == 0 ? 3 * r * r : 3 * r * (r + 1) + 1);
        triangles = s;
        for (std::size_t j = 1; j <= (n - 1) / 2; ++j) {
            const std::size_t m = n - 1 - 2 * j;
            triangles += m == 1 ? 4 : 6 * m;
        }
    }
    if (pattern.points.size() != points || pattern.indices.size() != 3 * triangles) {
        return fmt::format("{} points and {} triangles instead of {} and {}", pattern.points.size(),
                           pattern.indices.size() / 3, points, triangles);
    }
    return {};
}

// Outer segments as directed edges with the domain on their left: the ring is listed down U=0, along V=0 and back up
// W=0.
std::vector<std::uint32_t> outer_segments(Partitioning partitioning, const PatchFactors& factors,
                                          const Pattern& pattern) {
    std::vector<std::uint32_t> ring;
    if (partitioning == Partitioning::uniform) {
        const auto on_ring = [&](const DomainPoint& p) { return p.u == 0 || p.v == 0 || p.u + p.v == 65536; };
        for (std::uint32_t i = 0; i < pattern.points.size(); ++i) {
            if (on_ring(pattern.points[i])) ring.push_back(i);
        }
        // Counter-clockwise around the domain, from the corner (0, 0).
        const auto place = [&](std::uint32_t i) {
            const DomainPoint& p = pattern.points[i];
            return p.v == 0 ? p.u : (p.u + p.v == 65536 ? 65536 + p.v : 131072 + (65536 - p.v));
        };
        std::ranges::sort(ring, {}, place);
    } else {
        const std::uint32_t count = is_single(partitioning, factors) ? 3 : outer_point_count(partitioning, factors);
        for (std::uint32_t i = 0; i < count; ++i)
            ring.push_back(i);
    }
    std::vector<std::uint32_t> segments;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        segments.push_back(ring[i] << 16 | ring[(i + 1) % ring.size()]);
    }
    std::ranges::sort(segments);
    return segments;
}

}  // namespace

std::string describe(Partitioning partitioning, const PatchFactors& f) {
    return fmt::format("{} {} {} {} inside {}", name(partitioning), f[0], f[1], f[2], f[3]);
}

std::uint32_t expected_points(float factor, Partitioning partitioning, bool inner, bool splits) {
    double f = std::isnan(factor) ? 1.0 : factor;
    if (partitioning == Partitioning::fractional_odd) {
        const double least = inner && splits ? 1.0 + 0x1p-16 : 1.0;
        f = std::nearbyint(std::clamp(f, least, 63.0) * 65536.0) / 65536.0;
        return 2 * static_cast<std::uint32_t>(std::ceil((f + 1.0) / 2.0));
    }
    if (partitioning == Partitioning::fractional_even) {
        f = std::nearbyint(std::clamp(f, 2.0, 64.0) * 65536.0) / 65536.0;
        return 2 * static_cast<std::uint32_t>(std::ceil(f / 2.0)) + 1;
    }
    // An inside factor of one counts as even: two segments.
    const auto segments = static_cast<std::uint32_t>(std::ceil(std::clamp(f, 1.0, 64.0)));
    return inner && segments == 1 ? 3 : segments + 1;
}

bool is_single(Partitioning partitioning, const PatchFactors& f) {
    const bool small = std::max({f[0], f[1], f[2]}) <= 1.0f + 0x1p-17f && !(f[3] > 1.0f + 0x1p-17f);
    return partitioning == Partitioning::fractional_odd
               ? small
               : (partitioning != Partitioning::fractional_even && partitioning != Partitioning::uniform &&
                  std::max({f[0], f[1], f[2]}) <= 1.0f && !(f[3] > 1.0f));
}

std::uint32_t outer_point_count(Partitioning partitioning, const PatchFactors& factors) {
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        count += expected_points(factors[i], partitioning, false, false) - 1;
    }
    return count;
}

std::string check_triangle_pattern(Partitioning partitioning, const PatchFactors& factors, const Pattern& pattern) {
    const auto problem = [&](const std::string& what) {
        return fmt::format("{}: {}", describe(partitioning, factors), what);
    };
    if (const std::string counts = check_counts(partitioning, factors, pattern); !counts.empty()) {
        return problem(counts);
    }
    for (const DomainPoint& p : pattern.points) {
        if (p.u > 65536 || p.v > 65536 || p.u + p.v > 65536) {
            return problem(fmt::format("point {},{} lies outside", p.u, p.v));
        }
    }
    std::vector<bool> used(pattern.points.size());
    std::int64_t area = 0;
    for (std::size_t t = 0; t < pattern.indices.size(); t += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (pattern.indices[t + k] >= pattern.points.size()) {
                return problem(fmt::format("triangle {} uses point {}", t / 3, pattern.indices[t + k]));
            }
            used[pattern.indices[t + k]] = true;
        }
        area += twice_area(pattern.points[pattern.indices[t]], pattern.points[pattern.indices[t + 1]],
                           pattern.points[pattern.indices[t + 2]]);
    }
    if (std::ranges::find(used, false) != used.end()) {
        return problem("a point is not used");
    }
    if (area != std::int64_t{65536} * 65536) {
        return problem(fmt::format("twice the area is {}", area));
    }
    const std::vector<std::uint32_t> edges = directed_edges(pattern);
    if (std::ranges::adjacent_find(edges) != edges.end()) {
        return problem("a directed edge comes twice");
    }
    std::vector<std::uint32_t> open;
    for (const std::uint32_t edge : edges) {
        if (!std::ranges::binary_search(edges, edge >> 16 | edge << 16)) {
            open.push_back(edge);
        }
    }
    if (open != outer_segments(partitioning, factors, pattern)) {
        return problem(fmt::format("{} open edges are not the outer segments", open.size()));
    }
    return {};
}

std::size_t inverted_or_empty(const Pattern& pattern) {
    std::size_t count = 0;
    for (std::size_t t = 0; t < pattern.indices.size(); t += 3) {
        count += twice_area(pattern.points[pattern.indices[t]], pattern.points[pattern.indices[t + 1]],
                            pattern.points[pattern.indices[t + 2]]) > 0
                     ? 0
                     : 1;
    }
    return count;
}

std::vector<std::uint32_t> outer_edge(Partitioning partitioning, const PatchFactors& factors, const Pattern& pattern,
                                      int edge) {
    std::uint32_t first = 0;
    for (int i = 0; i < edge; ++i) {
        first += expected_points(factors[static_cast<std::size_t>(i)], partitioning, false, false) - 1;
    }
    const std::uint32_t count = expected_points(factors[static_cast<std::size_t>(edge)], partitioning, false, false);
    const std::uint32_t ring = outer_point_count(partitioning, factors);
    std::vector<std::uint32_t> coordinates;
    for (std::uint32_t i = 0; i < count; ++i) {
        const DomainPoint& p = pattern.points[(first + i) % ring];
        coordinates.push_back(edge == 0 ? p.v : p.u);
    }
    std::ranges::sort(coordinates);
    return coordinates;
}

}  // namespace tessera::test
