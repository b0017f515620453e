#include "tessellate/models.hpp"

#include "tessellate/welded.hpp"

namespace tessera::test {

patches::PatchSet load_patches(const std::string& name) {
    return patches::make_patches(scene::load_scene(name));
}

bool closed_and_smooth(const patches::PatchSet& set) {
    std::vector<std::uint32_t> triangles;  // quads as two; which diagonal does not matter here
    for (const patches::PatchCorners& c : set.corners) {
        triangles.insert(triangles.end(), {c[0], c[1], c[2]});
        if (patches::is_quad(c)) {
            triangles.insert(triangles.end(), {c[0], c[2], c[3]});
        }
    }
    return find_crack(weld(set.control_vertices, triangles, WeldBy::position_and_normal), true).empty() &&
           find_crack(weld(set.control_vertices, triangles, WeldBy::position), true).empty();
}

}  // namespace tessera::test
