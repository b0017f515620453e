// A mesh whose vertices are told by their bits, and the search for edges that lack a partner.
#pragma once

#include "tessellate/refined_mesh.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tessera::test {

enum class WeldBy { position, position_and_normal };

struct WeldedMesh {
    std::vector<std::uint32_t> triangles;  ///< three welded vertices each
    std::size_t collapsed = 0;             ///< triangles left out because two corners are one vertex
};

/// Vertices with equal bits become one.
WeldedMesh weld(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices, WeldBy by);

/// Empty where the mesh is closed: every directed edge has as many partners in the opposite direction, and, with
/// `manifold`, comes once. Else a sentence about the first edge that does not.
std::string find_crack(const WeldedMesh& mesh, bool manifold);

}  // namespace tessera::test
