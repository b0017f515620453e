// What every pattern of the quad domain must satisfy, whatever its factors.
#pragma once

#include "tessellate/pattern.hpp"

#include <array>
#include <string>

namespace tessera::test {

/// The factors a pattern was made from, as a sentence for failures.
std::string describe_quad(Partitioning partitioning, const PatchFactors& factors);

/// Sizes of a quad's pattern, from the text of the specification; not for culled patches, nor for the uniform grid.
struct QuadShape {
    bool single = false;                       ///< the four corners only
    std::array<std::uint32_t, 4> edge_points;  ///< of edges U=0, V=0, U=1, V=1, both ends included
    std::uint32_t inside_u = 0, inside_v = 0;  ///< points per inside axis
    std::uint32_t outer_points() const;
    std::uint32_t points() const;
    std::uint32_t triangles() const;
    std::uint32_t inner_triangles() const;  ///< those that touch no outer point; they come last
};
QuadShape quad_shape(Partitioning partitioning, const PatchFactors& factors);

/// Empty, or what is wrong with a clockwise pattern of positive factors: counts as specified; every point in the domain
/// and used; the signed area that of the domain, exactly; no directed edge twice; the open edges are those of the outer
/// ring, which lies on the boundary.
std::string check_quad_pattern(Partitioning partitioning, const PatchFactors& factors, const Pattern& pattern);

/// The coordinates along edge 0 (U=0), 1 (V=0), 2 (U=1) or 3 (V=1), both ends included and ascending, of a pattern that
/// is neither culled, single nor uniform.
std::vector<std::uint32_t> quad_edge(Partitioning partitioning, const PatchFactors& factors, const Pattern& pattern,
                                     std::size_t edge);

}  // namespace tessera::test
