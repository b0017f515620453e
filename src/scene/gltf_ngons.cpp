#include "scene/gltf_ngons.hpp"

namespace tessera::scene {

bool has_ngon_encoding(const tinygltf::Primitive& primitive) {
    return primitive.extensions.contains("FB_ngon_encoding");
}

void restore_quads(Mesh& mesh) {
    std::vector<std::uint32_t> triangles;
    const std::vector<std::uint32_t>& from = mesh.triangles;
    for (std::size_t i = 0; i < from.size();) {
        std::size_t end = i + 3;
        while (end < from.size() && from[end] == from[i])
            end += 3;
        const std::uint32_t* t = &from[i];
        // (a, b, c) and (a, c, d); mirrored nodes have turned them into (a, c, b) and (a, d, c).
        if (end - i == 6 && t[2] == t[4] && t[1] != t[5]) {
            mesh.quads.insert(mesh.quads.end(), {t[0], t[1], t[2], t[5]});
        } else if (end - i == 6 && t[1] == t[5] && t[2] != t[4]) {
            mesh.quads.insert(mesh.quads.end(), {t[0], t[4], t[1], t[2]});
        } else {
            triangles.insert(triangles.end(), from.begin() + static_cast<std::ptrdiff_t>(i),
                             from.begin() + static_cast<std::ptrdiff_t>(end));
        }
        i = end;
    }
    mesh.triangles = std::move(triangles);
}

}  // namespace tessera::scene
