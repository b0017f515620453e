// FB_ngon_encoding: polygons hidden in triangle lists.
#pragma once

#include "scene/gltf_document.hpp"
#include "scene/scene.hpp"

namespace tessera::scene {

/// True if the extension is listed on the primitive.
bool has_ngon_encoding(const tinygltf::Primitive& primitive);

/// Makes a quad of every run of exactly two triangles with the same first index that share the edge from it: that is
/// how the extension writes quads. Other runs, which are triangles and larger polygons, stay triangles.
void restore_quads(Mesh& mesh);

}  // namespace tessera::scene
