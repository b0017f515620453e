// What every pattern of the triangle domain must satisfy, whatever its factors.
#pragma once

#include "tessellate/pattern.hpp"

#include <string>

namespace tessera::test {

/// The factors a pattern was made from, as a sentence for failures.
std::string describe(Partitioning partitioning, const PatchFactors& factors);

/// Segments that a factor makes on its edge, from the text of the specification and floating-point numbers; `inner` for
/// the inside factor. Not for culled patches, nor for patches whose factors are all one.
std::uint32_t expected_points(float factor, Partitioning partitioning, bool inner, bool outer_splits);

/// True where the specification gives the single triangle.
bool is_single(Partitioning partitioning, const PatchFactors& factors);

/// Empty, or what is wrong with a clockwise pattern of positive factors:
///   - all points lie in the domain and each is used; the counts are those of the specification;
///   - the signed area is that of the domain, exactly; no directed edge comes twice;
///   - the edges with a triangle on one side only are the segments of the outer ring.
std::string check_triangle_pattern(Partitioning partitioning, const PatchFactors& factors, const Pattern& pattern);

/// The number of triangles whose area is not positive.
std::size_t inverted_or_empty(const Pattern& pattern);

/// The coordinates along edge 0 (U=0), 1 (V=0) or 2 (W=0), both ends included and ascending, of a pattern
/// that is neither culled, single nor uniform.
std::vector<std::uint32_t> outer_edge(Partitioning partitioning, const PatchFactors& factors, const Pattern& pattern,
                                      int edge);

/// Points on the three outer edges together.
std::uint32_t outer_point_count(Partitioning partitioning, const PatchFactors& factors);

}  // namespace tessera::test
