// A domain pattern as a file for people: .svg, .csv; and as a mesh to be drawn.
#pragma once

#include "tessellate/pattern.hpp"
#include "tessellate/refined_mesh.hpp"

#include <string>

namespace tessera::cli {

/// The pattern as an SVG of 640 x 560 units: triangles drawn as thin outlines in an equilateral triangle with control
/// point 0 (u = 1) at the lower right, 1 (v = 1) at the top, 2 at the lower left.
std::string pattern_svg(const Pattern& pattern);

/// One line per element: `point,INDEX,U,V` in 16.16 and `triangle,INDEX,A,B,C`, after a header.
std::string pattern_csv(const Pattern& pattern);

/// The pattern as a flat mesh facing +z.
std::vector<Vertex> pattern_vertices(const Pattern& pattern);

}  // namespace tessera::cli
