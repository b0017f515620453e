#include "tessellate/models.hpp"

#include "tessellate/welded.hpp"

namespace tessera::test {

patches::PatchSet load_patches(const std::string& name) {
    return patches::make_patches(scene::load_scene(name));
}

bool closed_and_smooth(const patches::PatchSet& set) {
    return find_crack(weld(set.control_vertices, set.indices, WeldBy::position_and_normal), true).empty() &&
           find_crack(weld(set.control_vertices, set.indices, WeldBy::position), true).empty();
}

}  // namespace tessera::test
