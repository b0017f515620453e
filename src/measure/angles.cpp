#include "measure/angles.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/glm.hpp>
#include <numeric>

namespace tessera::measure {

double angle_between(const float (&a)[3], const float (&b)[3]) {
    const glm::dvec3 u(a[0], a[1], a[2]);
    const glm::dvec3 v(b[0], b[1], b[2]);
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

AngleStatistics summarise(std::vector<double> angles) {
    AngleStatistics statistics;
    if (angles.empty()) return statistics;
    std::ranges::sort(angles);
    statistics.count = angles.size();
    statistics.mean = std::accumulate(angles.begin(), angles.end(), 0.0) / static_cast<double>(angles.size());
    statistics.most_95 = angles[(angles.size() * 95 + 99) / 100 - 1];
    statistics.max = angles.back();
    return statistics;
}

AngleStatistics normal_angles(const PatchSurface& a, const PatchSurface& b) {
    const auto same_position = [](const Vertex& p, const Vertex& q) {
        return std::memcmp(p.position, q.position, sizeof p.position) == 0;
    };
    if (!std::ranges::equal(a.vertices, b.vertices, same_position)) {
        throw Error(ErrorKind::usage, fmt::format("Normals are compared at equal vertices; these surfaces of {} and {} "
                                                  "vertices differ in positions.",
                                                  a.vertices.size(), b.vertices.size()));
    }
    std::vector<double> angles(a.vertices.size());
    std::ranges::transform(a.vertices, b.vertices, angles.begin(),
                           [](const Vertex& p, const Vertex& q) { return angle_between(p.normal, q.normal); });
    return summarise(std::move(angles));
}

}  // namespace tessera::measure
