#include "export/gltf_tangent.hpp"

#include <cmath>
#include <glm/glm.hpp>

namespace tessera::exporting {
namespace {

using glm::dvec3;

// Squared sine of the angle under which two directions count as parallel: there the rounding of floats shows.
constexpr double parallel = 1e-10;

/// What of `v` is at a right angle to the unit vector `n`.
dvec3 across(const dvec3& v, const dvec3& n) {
    return v - glm::dot(v, n) * n;
}

dvec3 farthest_axis(const dvec3& n) {
    const dvec3 size = glm::abs(n);
    if (size.x <= size.y && size.x <= size.z) return {1, 0, 0};
    return size.y <= size.z ? dvec3{0, 1, 0} : dvec3{0, 0, 1};
}

}  // namespace

GltfTangent gltf_tangent(const Vertex& vertex, const Tangent& frame) {
    const dvec3 n = glm::normalize(dvec3{vertex.normal[0], vertex.normal[1], vertex.normal[2]});
    const dvec3 bitangent{frame.bitangent[0], frame.bitangent[1], frame.bitangent[2]};
    dvec3 t = across({frame.tangent[0], frame.tangent[1], frame.tangent[2]}, n);
    if (glm::dot(t, t) < parallel) t = glm::cross(bitangent, n) * static_cast<double>(frame.handedness);
    if (glm::dot(t, t) < parallel) t = across(farthest_axis(n), n);
    t = glm::normalize(t);
    return {static_cast<float>(t.x), static_cast<float>(t.y), static_cast<float>(t.z), frame.handedness};
}

}  // namespace tessera::exporting
