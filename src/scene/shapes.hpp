// Shapes that need no file.
#pragma once

#include "scene/scene.hpp"

#include <string_view>

namespace tessera::scene {

/// True for names that begin with "shape:".
bool is_shape(std::string_view name);

/// Makes the shape of that name. Each is one closed mesh around the origin, wound counter-clockwise from outside, with
/// texture coordinates; vertices that lie on a texture seam come several times, with equal bits in position and normal.
/// - `shape:icosahedron`: radius 1, normals of the sphere, 20 triangles.
/// - `shape:cube`: corners at +-1, 12 triangles. Normals point along the diagonals and are shared by the three faces
///   of a corner: it rounds when tessellated and stays closed, as hard edges would not.
/// - `shape:torus`: radii 1 and 0.4 around the y axis, 12 by 8 segments, 192 triangles.
/// - `shape:sphere:N`: radius 1, an octahedron with N segments per quarter circle, 8 N^2 triangles, N in [1, 256].
/// Throws Error(usage) for any other name, with a list of those there are.
Scene make_shape(std::string_view name);

}  // namespace tessera::scene
