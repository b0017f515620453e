// Vertex colours and tangents of a primitive.
#pragma once

#include "scene/gltf_primitive.hpp"

namespace tessera::scene {

/// Reads COLOR_0 and TANGENT into `out`. Colours are clamped to [0, 1] and get an alpha of 1 where the file has none.
/// Messages count what was out of range or not finite, and name further sets of colours, which are left out.
void read_vertex_attributes(const Document& document, SourcePrimitive& out);

}  // namespace tessera::scene
