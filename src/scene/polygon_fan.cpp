#include "scene/polygons.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tessera::scene {
namespace {

/// Twice the signed area of a triangle. Differences of floats and their products are exact enough in double.
double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Cuts one polygon whose plane projection runs counter-clockwise.
class EarClipper {
public:
    explicit EarClipper(std::vector<glm::dvec2> points) : points_(std::move(points)), next_(points_.size()) {
        for (std::size_t i = 0; i < next_.size(); ++i)
            next_[i] = (i + 1) % next_.size();
    }

    /// Calls emit(a, b, c) for n - 2 triangles, named by places in the polygon.
    template <typename Emit>
    void run(Emit emit) {
        std::size_t left = points_.size();
        std::size_t before = left - 1;
        while (left > 3) {
            before = find_ear(before, left);
            const std::size_t ear = next_[before];
            emit(before, ear, next_[ear]);
            next_[before] = next_[ear];
            before = next_[before];  // go on beyond the cut, so that triangles do not all share one corner
            --left;
        }
        emit(before, next_[before], next_[next_[before]]);
    }

private:
    /// The place before an ear, searched from `start` on. Without one, the corner that is least bad.
    std::size_t find_ear(std::size_t start, std::size_t left) const {
        std::size_t best = start;
        double best_area = -std::numeric_limits<double>::infinity();
        std::size_t at = start;
        for (std::size_t i = 0; i < left; ++i, at = next_[at]) {
            if (is_ear(at)) return at;
            const double size = area_at(at);
            if (size > best_area) {
                best = at;
                best_area = size;
            }
        }
        return best;
    }

    double area_at(std::size_t before) const {
        const std::size_t ear = next_[before];
        return area(points_[before], points_[ear], points_[next_[ear]]);
    }

    bool is_ear(std::size_t before) const {
        const std::size_t ear = next_[before];
        const std::size_t after = next_[ear];
        if (!(area_at(before) > 0.0)) return false;
        const glm::dvec2 &a = points_[before], &b = points_[ear], &c = points_[after];
        for (std::size_t last = after, at = next_[after]; at != before; last = at, at = next_[at]) {
            const glm::dvec2& p = points_[at];
            if (area(a, b, p) < 0.0 || area(b, c, p) < 0.0 || area(c, a, p) < 0.0) continue;
            // Where a bridge to a hole runs forth and back, a corner of the ear occurs twice. That one is in the way
            // only if the outline goes on from it into the ear.
            const bool corner_again = p == a || p == b || p == c;
            if (!corner_again || enters(a, b, c, p, points_[last]) || enters(a, b, c, p, points_[next_[at]]))
                return false;
        }
        return true;
    }

    /// True if the way from p, a corner of the triangle, to q begins in the triangle's inside.
    static bool enters(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& p,
                       const glm::dvec2& q) {
        const std::array<const glm::dvec2*, 3> corner{&a, &b, &c};
        for (std::size_t i = 0; i < 3; ++i) {
            if (*corner[i] != p) continue;
            return area(p, *corner[(i + 1) % 3], q) > 0.0 && area(p, *corner[(i + 2) % 3], q) < 0.0;
        }
        return false;
    }

    std::vector<glm::dvec2> points_;
    std::vector<std::size_t> next_;
};

/// Drops the axis along which the normal is longest: that keeps coordinates exact. Turns so that the outline runs
/// counter-clockwise.
std::vector<glm::dvec2> project(const Polygons& polygons, const Polygon& face) {
    const glm::dvec3 normal = vector_area(polygons, face);
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
        if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    }
    const int u = (axis + (normal[axis] < 0.0 ? 2 : 1)) % 3;
    const int v = (axis + (normal[axis] < 0.0 ? 1 : 2)) % 3;
    std::vector<glm::dvec2> points;
    for (const Corner& corner : polygons.corners_of(face)) {
        const glm::dvec3 p(polygons.positions[corner.position]);
        points.emplace_back(p[u], p[v]);
    }
    return points;
}

}  // namespace

glm::dvec3 vector_area(const Polygons& polygons, const Polygon& face) {
    const std::span<const Corner> corners = polygons.corners_of(face);
    const auto at = [&](std::size_t i) { return glm::dvec3(polygons.positions[corners[i].position]); };
    glm::dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(at(i) - at(0), at(i + 1) - at(0));
    return sum;
}

bool is_star_shaped(const Polygons& polygons, const Polygon& face) {
    const std::vector<glm::dvec2> points = project(polygons, face);
    glm::dvec2 mean(0.0);
    for (const glm::dvec2& p : points)
        mean += p / static_cast<double>(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!(area(points[i], points[(i + 1) % points.size()], mean) > 0.0)) return false;
    }
    return true;
}

void fan_polygons(Polygons& polygons, bool only_hidden) {
    std::vector<Polygon> faces;
    std::vector<Corner> corners;
    faces.reserve(polygons.faces.size());
    corners.reserve(polygons.corners.size());
    const auto add = [&](Polygon face, std::span<const Corner> around) {
        face.first = corners.size();
        face.count = static_cast<std::uint32_t>(around.size());
        corners.insert(corners.end(), around.begin(), around.end());
        faces.push_back(face);
    };
    for (const Polygon& face : polygons.faces) {
        const std::span<const Corner> around = polygons.corners_of(face);
        if (around.size() <= 4 || (only_hidden && is_star_shaped(polygons, face))) {
            add(face, around);
        } else {
            // Triangles that name a position twice lie between the two sides of a bridge to a hole.
            EarClipper(project(polygons, face)).run([&](std::size_t a, std::size_t b, std::size_t c) {
                const std::uint32_t p = around[a].position, q = around[b].position, r = around[c].position;
                if (p != q && q != r && r != p) add(face, std::array{around[a], around[b], around[c]});
            });
        }
    }
    polygons.faces = std::move(faces);
    polygons.corners = std::move(corners);
}

}  // namespace tessera::scene
