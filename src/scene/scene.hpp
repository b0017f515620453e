// What a model file holds, ready to tessellate: triangles and quads in world space, materials, images.
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

/// A semi-sharp edge of a subdivision cage; 0 is smooth, 10 and more infinitely sharp.
struct Crease {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    float sharpness = 0.0f;
};

/// A semi-sharp vertex of a subdivision cage.
struct SharpVertex {
    std::uint32_t vertex = 0;
    float sharpness = 0.0f;
};

/// What Pixar's tag lines of an OBJ file say about a mesh. A vertex number names all vertices of the mesh at bitwise
/// that position: it is the index of the first vertex made from the file's position. Every crease is an edge of a face.
struct SubdivisionTags {
    std::vector<Crease> creases;
    std::vector<SharpVertex> corners;
    std::vector<std::uint32_t> holes;  ///< faces that were left out: numbers from 0 over the face lines of the file
    int interpolate_boundary = 0;      ///< as in the file: 0 nothing, 1 edges and corners, 2 edges only
};

/// One primitive of one node, or the faces of one object, group and material. All values are finite and no number is a
/// negative zero in positions, so equal positions have equal bits. Winding is counter-clockwise from the front,
/// mirrored nodes included. No triangle or quad names a vertex twice, but it may have no area, and a quad need be
/// neither plane nor convex. A mesh has at least one triangle or quad.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;  ///< world space
    std::vector<glm::vec3> normals;    ///< unit, one per position
    std::vector<glm::vec2> uvs;  ///< one per position; zero where the file has none. KHR_texture_transform is applied
    std::vector<std::uint32_t> triangles;  ///< three indices per triangle, all < positions.size()
    std::vector<std::uint32_t> quads;      ///< four indices per quad, all < positions.size(); none from triangle files
    std::uint32_t material = 0;            ///< index into Scene::materials
    SubdivisionTags tags;
};

/// A camera of the file, in world space. It looks along -axes[2].
struct Camera {
    std::string name;  ///< of its node, else its own; may be empty
    glm::dvec3 eye{0.0};
    glm::dmat3 axes{1.0};  ///< right, up and back: orthonormal
    bool orthographic = false;
    /// Half the height of what it sees: orthographic in the model's units, perspective at distance 1 (the tangent of
    /// half the angle). Above 0.
    double half_height = 0.0;
    double half_width = 0.0;  ///< likewise; 0 where the file leaves it to the image
    double near_plane = 0.0;  ///< at least 0, in perspective above it
    double far_plane = 0.0;   ///< above near_plane, may be infinite
};

struct Scene {
    std::string source;               ///< file or shape name, for messages
    std::vector<Mesh> meshes;         ///< in node order
    std::vector<Material> materials;  ///< at least one
    std::vector<SceneImage> images;
    std::vector<Camera> cameras;        ///< in node order
    std::vector<std::string> messages;  ///< what was skipped or repaired, a sentence each
};

/// What becomes of OBJ faces with more than four corners.
enum class NgonMode {
    /// If a file has any, all its faces are split once as Catmull-Clark does, but with linear positions: a corner, the
    /// middles of its two edges and the mean of the corners make a quad. All faces, because the new vertex on an edge
    /// has to be there for the neighbour too: the mesh stays watertight, and consists of quads only. Faces so concave
    /// that this would fold them over are cut into triangles first.
    split,
    /// They are cut into triangles by ear clipping in the plane that fits best; all other faces stay as they are.
    fan,
};

struct LoadOptions {
    NgonMode ngons = NgonMode::split;
    /// Replaces all normals by angle-weighted ones over the whole scene, welded by position: hard edges become round,
    /// and a closed model stays closed under every scheme.
    bool smooth_normals = false;
};

/// Loads `name`: a .gltf or .glb file (glTF 2.0), a .obj file (Wavefront, polygons), or a built-in shape (see
/// shapes.hpp): `shape:icosahedron`, `shape:cube`, `shape:torus`, `shape:sphere:N` with N in [1, 256] segments per
/// quarter. Whether a glTF file is binary or text is told by its content.
///
/// glTF: nodes are baked into world space in double precision; skins and morph targets are taken in the file's rest
/// pose. Triangles that FB_ngon_encoding marks as two halves of a quad become a quad. Normals that the file gives are
/// kept (made unit); those it does not give are angle-weighted over all faces of the node at the same position.
///
/// OBJ: see load_obj.hpp for the rules.
///
/// Points, lines, animations and whatever else is not drawn are named in `messages`. A file that is sound but holds no
/// faces gives a scene without meshes: whether that is an error is up to the caller. The limits on sizes are those of
/// limits.hpp.
///
/// Throws Error(usage) with file, element and reason for anything unsound or not supported.
Scene load_scene(const std::string& name, const LoadOptions& options = {});

}  // namespace tessera::scene
