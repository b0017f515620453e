// OBJ files made in the test.
#pragma once

#include "scene/gltf_builder.hpp"

#include <string>

namespace tessera::test {

inline scene::Scene load_obj_text(const std::string& text, scene::NgonMode ngons = scene::NgonMode::split) {
    const TemporaryFolder folder;
    return scene::load_scene(folder.write("model.obj", text).string(), {.ngons = ngons});
}

inline std::string obj_refusal(const std::string& text) {
    const TemporaryFolder folder;
    return refusal(folder.write("model.obj", text).string());
}

/// The corners of a unit square, counter-clockwise seen from +z.
inline const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// A cube as six quads that face outward, corners -1 and 1.
inline const std::string cube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// The same with its first face in two triangles and its second as a pentagon (a corner on an edge, used next door
/// too).
inline const std::string mixed_cube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nv 0 -1 1\n"
    "f 4 3 2\nf 4 2 1\nf 5 9 6 7 8\nf 1 2 6 9 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

}  // namespace tessera::test
