// What a model file holds, ready to tessellate: triangles in world space, materials, images.
#pragma once

#include "image/image.hpp"

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tessera::scene {

enum class AlphaMode { opaque, mask, blend };

struct Material {
    std::string name;
    glm::vec4 base_color{1.0f};                     ///< linear RGBA factor
    std::optional<std::uint32_t> base_color_image;  ///< index into Scene::images, addressed with uv, repeat wrap
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
};

/// An image as it stood in the file (for writing it out again) and decoded.
struct SceneImage {
    std::string name;
    std::string mime_type;  ///< "image/png" or "image/jpeg"
    std::vector<std::byte> encoded;
    image::Image pixels;
};

/// One primitive of one node. All values are finite and no number is a negative zero in positions, so equal positions
/// have equal bits. Winding is counter-clockwise from the front, mirrored nodes included. No triangle names a vertex
/// twice, but it may have no area.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;  ///< world space
    std::vector<glm::vec3> normals;    ///< unit, one per position
    std::vector<glm::vec2> uvs;  ///< one per position; zero where the file has none. KHR_texture_transform is applied
    std::vector<std::uint32_t> triangles;  ///< three indices per triangle, all < positions.size()
    std::vector<std::uint32_t> quads;
    std::uint32_t material = 0;            ///< index into Scene::materials
};

struct Scene {
    std::string source;               ///< file or shape name, for messages
    std::vector<Mesh> meshes;         ///< in node order
    std::vector<Material> materials;  ///< at least one
    std::vector<SceneImage> images;
    std::vector<std::string> messages;  ///< what was skipped or repaired, a sentence each
};

/// Loads `name`: a .gltf or .glb file (glTF 2.0), or a built-in shape (see shapes.hpp): `shape:icosahedron`,
/// `shape:cube`, `shape:torus`, `shape:sphere:N` with N in [1, 256] segments per quarter. Whether a file is binary or
/// text is told by its content.
///
/// Nodes are baked into world space in double precision; skins and morph targets are taken in the file's rest pose.
/// Normals that the file gives are kept (made unit); those it does not give are angle-weighted over all triangles of
/// the node at the same position. Points, lines, animations and whatever else is not drawn are named in `messages`.
/// A file that is sound but holds no triangles gives a scene without meshes: whether that is an error is up to the
/// caller. The limits on sizes are those of limits.hpp.
///
/// Throws Error(usage) with file, element and reason for anything unsound or not supported.
Scene load_scene(const std::string& name);

}  // namespace tessera::scene
