// Tangents for normal maps where a file has none.
#pragma once

#include "base/vertex.hpp"
#include "patches/patches.hpp"

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace tessera::patches {

/// Tangents of the corners of faces by the algorithm of MikkTSpace (Mikkelsen, "Simulation of wrinkled surfaces
/// revisited", 2008, and the notes at mikktspace.com), which glTF 2.0, section 3.7.2.1, asks for: corners of equal
/// position, normal and texture coordinates share a tangent where they lie around a vertex without a seam and their
/// texture runs the same way round; it is the angle-weighted mean of the faces' tangents in the plane of the normal.
///
/// `faces` name `vertices`, whose positions, normals (unit) and texture coordinates are read; the coordinates pass
/// through `placement` first (u, v, 1), as the normal map has it. Returns one per corner: x, y, z of the tangent, unit,
/// and w, so that green of the map, which points against the second coordinate in glTF, is along w * cross(normal,
/// tangent). The fourth of a triangle is zero. Corners that nothing determines get (1, 0, 0). Nothing in the result
/// depends on the order of equal vertices; faces whose texture has no area join what they meet first.
///
/// Differences to the original code: it makes groups apart of faces around a vertex whose tangents are opposite to the
/// bit, this does only where at most 64 faces meet, so that the time does not grow with the square of their number;
/// and it may overlook that faces are neighbours at an edge that more than two share, or at the last of all vertices.
std::vector<std::array<glm::vec4, 4>> corner_tangents(std::span<const Vertex> vertices,
                                                      std::span<const PatchCorners> faces,
                                                      const glm::mat3& placement = glm::mat3(1.0f));

}  // namespace tessera::patches
