// What a glTF file says about the shape of the surface beyond positions and normals.
#pragma once

#include "scene/gltf_primitive.hpp"

namespace tessera::scene {

/// Reads `_ALPHA` (or the mesh's extras.alpha) and `_STPN` into `out`, whose positions must be there; both are left
/// empty where the file has nothing. Values are clamped to their range, what is not finite becomes zero, and an
/// attribute of another type is left out, each with a message.
void read_shape_tags(const Document& document, const tinygltf::Mesh& mesh, SourcePrimitive& out);

}  // namespace tessera::scene
