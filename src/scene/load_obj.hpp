// Wavefront OBJ: text with polygons.
#pragma once

#include "scene/scene.hpp"

#include <filesystem>

namespace tessera::scene {

/// Reads an OBJ file with the material libraries and textures that it names inside its folder.
///
/// - Triangles and quads stay what they are; larger faces are treated as `ngons` says. There is a mesh for each object,
///   group and material that has faces, in the order of their first face.
/// - Vertex normals of the file are kept (made unit). Where a corner has none, it follows the smoothing group: 0 or
///   `off` gives the face's own normal, any other the angle-weighted mean over the faces of that group at the position
///   (see normals.hpp). Faces before any `s` statement form a group of their own and are smoothed.
/// - v is turned round (1 - v): OBJ's origin is the texture's lower left corner, glTF's and ours the upper left one.
/// - Left out, counted in messages: faces of fewer than three different corners, faces with a coordinate that is no
///   finite number, holes (tags), positions that no face uses, lines and points, statements of free-form surfaces.
///   Edges of more than two faces and faces without area stay, counted in messages.
/// - Pixar's tags become Mesh::tags. A crease that belongs to two meshes is in both. If faces are split, a crease
/// becomes
///   two of the same sharpness.
///
/// Throws Error(usage) with file, line and reason for text that makes no sense: an index that is 0, out of range or no
/// number, too few coordinates, a file without vertices, or one beyond the limits of limits.hpp.
Scene load_obj(const std::filesystem::path& path, const LoadOptions& options);

}  // namespace tessera::scene
