#include "measure/distance.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tessera::measure {
namespace {

glm::dvec3 position(const Vertex& v) {
    return {v.position[0], v.position[1], v.position[2]};
}

double squared_distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 along = b - a;
    const double length_squared = glm::dot(along, along);
    const double t = length_squared > 0.0 ? std::clamp(glm::dot(p - a, along) / length_squared, 0.0, 1.0) : 0.0;
    const glm::dvec3 off = p - (a + t * along);
    return glm::dot(off, off);
}

struct Triangle {
    glm::dvec3 a, b, c;
    glm::dvec3 middle;
    double radius;  // of a ball around `middle` that holds it
};

Triangle make_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 middle = (a + b + c) / 3.0;
    const double radius = std::max({glm::length(a - middle), glm::length(b - middle), glm::length(c - middle)});
    return {a, b, c, middle, radius * 1.000001};
}

double squared_distance(const glm::dvec3& p, const Triangle& t) {
    const glm::dvec3 normal = glm::cross(t.b - t.a, t.c - t.a);
    const double area_squared = glm::dot(normal, normal);
    // Inside all three edges the foot on the plane is nearest, else a point of an edge.
    if (area_squared > 0.0 && glm::dot(glm::cross(t.b - t.a, p - t.a), normal) >= 0.0 &&
        glm::dot(glm::cross(t.c - t.b, p - t.b), normal) >= 0.0 &&
        glm::dot(glm::cross(t.a - t.c, p - t.c), normal) >= 0.0) {
        const double height = glm::dot(p - t.a, normal);
        return height * height / area_squared;
    }
    return std::min({squared_distance_to_segment(p, t.a, t.b), squared_distance_to_segment(p, t.b, t.c),
                     squared_distance_to_segment(p, t.c, t.a)});
}

std::vector<Triangle> triangles_of(const PatchSurface& surface, std::size_t patch) {
    std::vector<Triangle> triangles;
    const std::span<const std::uint32_t> indices = surface.patch_indices(patch);
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        triangles.push_back(make_triangle(position(surface.vertices[indices[i]]),
                                          position(surface.vertices[indices[i + 1]]),
                                          position(surface.vertices[indices[i + 2]])));
    }
    return triangles;
}

std::vector<glm::dvec3> grid_points(const std::vector<Triangle>& triangles, std::uint32_t steps) {
    std::vector<glm::dvec3> points;
    for (const Triangle& t : triangles) {
        for (std::uint32_t i = 0; i <= steps; ++i) {
            for (std::uint32_t j = 0; i + j <= steps; ++j) {
                const double u = static_cast<double>(i) / steps;
                const double v = static_cast<double>(j) / steps;
                points.push_back((1.0 - u - v) * t.a + u * t.b + v * t.c);
            }
        }
    }
    return points;
}

struct Sum {
    std::uint64_t count = 0;
    double sum = 0.0;
    double max = 0.0;

    void add(const std::vector<glm::dvec3>& points, const std::vector<Triangle>& triangles) {
        std::size_t near = 0;  // the next point is mostly close to the triangle that was nearest to the last
        for (const glm::dvec3& p : points) {
            double distance = std::sqrt(squared_distance(p, triangles[near]));
            for (std::size_t i = 0; i < triangles.size(); ++i) {
                const glm::dvec3 off = p - triangles[i].middle;
                const double reach = distance + triangles[i].radius;
                if (glm::dot(off, off) >= reach * reach) continue;
                const double d = std::sqrt(squared_distance(p, triangles[i]));
                if (d < distance) {
                    distance = d;
                    near = i;
                }
            }
            sum += distance;
            max = std::max(max, distance);
        }
        count += points.size();
    }
};

/// Runs `measure(patch, sum)` for every patch; sums are added in the order of the patches, so that the result does not
/// depend on timing.
template <typename Measure>
DistanceStatistics over_patches(const PatchSurface& a, const PatchSurface& b, const Measure& measure) {
    if (a.patch_count() != b.patch_count()) {
        throw Error(ErrorKind::usage, fmt::format("Distances are measured patch by patch; the surfaces have {} and {}.",
                                                  a.patch_count(), b.patch_count()));
    }
    std::vector<Sum> sums(a.patch_count());
    tbb::parallel_for(std::size_t{0}, sums.size(), [&](std::size_t patch) { measure(patch, sums[patch]); });
    DistanceStatistics statistics;
    for (const Sum& sum : sums) {
        statistics.count += sum.count;
        statistics.mean += sum.sum;
        statistics.max = std::max(statistics.max, sum.max);
    }
    if (statistics.count > 0) statistics.mean /= static_cast<double>(statistics.count);
    return statistics;
}

}  // namespace

double distance_to_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return std::sqrt(squared_distance(p, make_triangle(a, b, c)));
}

DistanceStatistics distance_of_vertices(const PatchSurface& samples, const PatchSurface& surface) {
    return over_patches(samples, surface, [&](std::size_t patch, Sum& sum) {
        std::vector<glm::dvec3> points;
        for (const Vertex& v : samples.patch_vertices(patch))
            points.push_back(position(v));
        sum.add(points, triangles_of(surface, patch));
    });
}

DistanceStatistics distance_between(const PatchSurface& a, const PatchSurface& b, std::uint32_t steps) {
    return over_patches(a, b, [&](std::size_t patch, Sum& sum) {
        const std::vector<Triangle> of_a = triangles_of(a, patch);
        const std::vector<Triangle> of_b = triangles_of(b, patch);
        sum.add(grid_points(of_a, steps), of_b);
        sum.add(grid_points(of_b, steps), of_a);
    });
}

double diagonal(const PatchSurface& surface) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high(-std::numeric_limits<double>::infinity());
    for (const Vertex& v : surface.vertices) {
        low = glm::min(low, position(v));
        high = glm::max(high, position(v));
    }
    return surface.vertices.empty() ? 0.0 : glm::length(high - low);
}

}  // namespace tessera::measure
