// A domain pattern as a file for people: .svg, .csv; and as a mesh to be drawn.
#pragma once

#include "tessellate/pattern.hpp"
#include "tessellate/refined_mesh.hpp"

#include <string>

namespace tessera::cli {

/// The pattern as an SVG of 640 units width, outlines of its triangles or lines. Triangles lie in an equilateral
/// triangle with control point 0 (u = 1) at the lower right, 1 (v = 1) at the top, 2 at the lower left; quads and
/// isolines in a square with u to the right and v up.
std::string pattern_svg(const Pattern& pattern, Domain domain);

/// One line per element after a header: `point,INDEX,U,V` in 16.16, then `triangle,INDEX,A,B,C` or `line,INDEX,A,B`.
std::string pattern_csv(const Pattern& pattern, Domain domain);

/// The points as vertices of a flat mesh in the unit square that faces +z.
std::vector<Vertex> pattern_vertices(const Pattern& pattern, Domain domain);

}  // namespace tessera::cli
