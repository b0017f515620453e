#include "patches/guide_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <optional>

namespace tessera::patches {
namespace {

// A root of a Delaunay triangulation has six neighbours on average; the rest is room for uneven ones.
constexpr std::size_t nearest_looked_at = 20;

struct Cloud {
    std::vector<glm::dvec3> points;

    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][static_cast<glm::length_t>(axis)]; }
    template <typename Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3, std::uint32_t>;

/// Moves every root by up to about a thousandth of the mean distance between neighbours, by its number alone: of four
/// roots on one circle it decides for one of the two ways to cut them.
void disturb(std::vector<glm::dvec3>& points) {
    glm::dvec3 low(std::numeric_limits<double>::max());
    glm::dvec3 high(-low);
    for (const glm::dvec3& p : points) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const double step = glm::length(high - low) / std::sqrt(static_cast<double>(points.size())) * 1e-3;
    std::uint32_t state = 1;
    for (glm::dvec3& p : points) {
        for (int axis = 0; axis < 3; ++axis) {
            state = state * 1664525u + 1013904223u;
            p[axis] += step * (static_cast<double>(state >> 8) * 0x1p-24 - 0.5);
        }
    }
}

struct Neighbours {
    std::vector<std::uint32_t> nearest;  // nearest first, the root itself left out
    double reach = 0.0;                  // every root nearer than this is in the list
};

Neighbours neighbours_of(const Tree& tree, const std::vector<glm::dvec3>& points, std::uint32_t root) {
    std::vector<std::uint32_t> found(nearest_looked_at + 1);
    std::vector<double> squares(found.size());
    const std::size_t count = tree.knnSearch(&points[root].x, found.size(), found.data(), squares.data());
    Neighbours neighbours;
    neighbours.reach = count < found.size() ? std::numeric_limits<double>::infinity() : std::sqrt(squares[count - 1]);
    for (std::size_t i = 0; i < count; ++i) {
        if (found[i] != root) neighbours.nearest.push_back(found[i]);
    }
    return neighbours;
}

struct Sphere {
    glm::dvec3 centre;
    double square;
};

/// The smallest sphere through three points; none where they lie on a line or nearly so (an angle above 168 degrees).
std::optional<Sphere> sphere_through(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const glm::dvec3 across = glm::cross(ab, ac);
    const double area = glm::dot(across, across);
    if (!(area > 1e-12 * glm::dot(ab, ab) * glm::dot(ac, ac))) return std::nullopt;
    const glm::dvec3 to_centre =
        (glm::cross(across, ab) * glm::dot(ac, ac) + glm::cross(ac, across) * glm::dot(ab, ab)) / (2.0 * area);
    const double square = glm::dot(to_centre, to_centre);
    const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(c - b, c - b)});
    if (!(longest > 0.16 * square)) return std::nullopt;  // the sine of that angle is longest / (2 radius)
    return Sphere{a + to_centre, square};
}

/// The smallest sphere through two points.
Sphere sphere_through(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 half = (b - a) * 0.5;
    return {a + half, glm::dot(half, half)};
}

/// Whether a sphere through the root of a list, `b` and `c` holds another point of the list.
bool holds_another(const Sphere& sphere, const std::vector<glm::dvec3>& points, const Neighbours& around,
                   std::uint32_t b, std::uint32_t c) {
    return std::ranges::any_of(around.nearest, [&](std::uint32_t other) {
        const glm::dvec3 away = points[other] - sphere.centre;
        return other != b && other != c && glm::dot(away, away) < sphere.square;
    });
}

bool opposed(const glm::vec3& a, const glm::vec3& b) {
    return glm::dot(a, b) < 0.0f;
}

}  // namespace

std::vector<HairPatch> neighbouring_guides(std::span<const glm::vec3> roots, std::span<const glm::vec3> normals) {
    Cloud cloud{{roots.begin(), roots.end()}};
    if (cloud.points.empty()) return {};
    disturb(cloud.points);
    const Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(16));
    const auto count = static_cast<std::uint32_t>(roots.size());
    std::vector<HairPatch> patches;
    std::vector<bool> in_triangle(count, false);
    for (std::uint32_t root = 0; root < count; ++root) {
        const Neighbours around = neighbours_of(tree, cloud.points, root);
        for (std::size_t i = 0; i < around.nearest.size(); ++i) {
            for (std::size_t j = i + 1; j < around.nearest.size(); ++j) {
                const std::uint32_t b = around.nearest[i];
                const std::uint32_t c = around.nearest[j];
                if (opposed(normals[root], normals[b]) || opposed(normals[b], normals[c]) ||
                    opposed(normals[c], normals[root])) {
                    continue;
                }
                const auto sphere = sphere_through(cloud.points[root], cloud.points[b], cloud.points[c]);
                if (!sphere || 2.0 * std::sqrt(sphere->square) > around.reach) continue;
                if (holds_another(*sphere, cloud.points, around, b, c)) continue;
                HairPatch patch{root, b, c};
                std::ranges::sort(patch);
                patches.push_back(patch);
                for (const std::uint32_t guide : patch)
                    in_triangle[guide] = true;
            }
        }
    }
    for (std::uint32_t root = 0; root < count; ++root) {
        if (in_triangle[root]) continue;
        const Neighbours around = neighbours_of(tree, cloud.points, root);
        bool alone = true;
        for (const std::uint32_t other : around.nearest) {
            if (opposed(normals[root], normals[other])) continue;
            const Sphere sphere = sphere_through(cloud.points[root], cloud.points[other]);
            if (holds_another(sphere, cloud.points, around, other, other)) continue;
            patches.push_back({std::min(root, other), std::max(root, other), no_guide});
            alone = false;
        }
        if (alone) patches.push_back({root, no_guide, no_guide});
    }
    std::ranges::sort(patches);
    patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
    return patches;
}

}  // namespace tessera::patches
