// The checked statements of an OBJ file as polygons, through tinyobjloader.
#pragma once

#include "scene/obj_text.hpp"
#include "scene/polygons.hpp"

namespace tessera::scene {

/// Every face statement as a polygon, in order, as the file has it: holes and degenerate faces included. v is turned to
/// point down (1 - v), normals are made unit, and those that cannot be are left away.
Polygons read_obj(const ObjText& text, Diagnostics& diagnostics);

/// Removes what no surface can be made of, and says how much: holes, faces with an unusable position, corners that
/// repeat the one before or run back to it, and faces of which fewer than three corners are left.
void clean_polygons(Polygons& polygons, const ObjText& text, Diagnostics& diagnostics);

/// Notes edges of more than two faces (which stay) and positions that no face uses (which do not).
void note_topology(const Polygons& polygons, Diagnostics& diagnostics);

}  // namespace tessera::scene
