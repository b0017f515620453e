// Where patches meet, and how far their normals are apart there.
#pragma once

#include "measure/angles.hpp"
#include "measure/patch_surface.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace tessera::measure {

/// Edge i of a patch leads from its corner i to the next.
struct PatchEdge {
    std::uint32_t patch = 0;
    std::uint32_t edge = 0;
};

/// Two patches along one edge.
struct SharedEdge {
    std::array<PatchEdge, 2> sides;
    bool reversed = true;  ///< the second runs the other way, as neighbours of like winding do
};

/// Edges by the positions of their ends, bit by bit, so that seams of textures do not count as boundaries.
struct PatchEdges {
    std::vector<SharedEdge> smooth;  ///< of two patches that have the same normals at its ends, bit by bit
    std::uint64_t split = 0;         ///< of two patches with normals of their own at an end
    std::uint64_t boundary = 0;      ///< of one patch
    std::uint64_t crowded = 0;       ///< of three patches and more
    std::uint64_t without_length = 0;
};

PatchEdges find_edges(const patches::PatchSet& patches);

/// The points of a pattern on an edge of its domain, from corner `edge` to the next, both included: indices into
/// `pattern.points`.
std::vector<std::uint32_t> points_on_edge(const Pattern& pattern, bool quad, std::uint32_t edge);

/// The angles between the normals that the two patches give at each vertex of each smooth edge, its ends included.
/// Throws Error(usage) where the two have not the same positions there, bit by bit.
AngleStatistics discontinuity(const PatchSurface& surface, const PatchEdges& edges);

}  // namespace tessera::measure
