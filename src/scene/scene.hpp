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

/// What becomes of texture coordinates outside [0, 1].
enum class Wrap { repeat, clamp, mirror };

/// An image on a surface.
struct Map {
    std::uint32_t image = 0;  ///< index into Scene::images
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    /// Its coordinates are this times (u, v, 1) of Mesh::uvs.
    glm::mat3 transform{1.0f};
};

/// The maps of a metallic-roughness material besides its base colour; see LoadOptions::all_maps.
struct Maps {
    std::optional<Map> metallic_roughness;  ///< blue and green
    std::optional<Map> normal;
    std::optional<Map> occlusion;  ///< red
    std::optional<Map> emissive;   ///< sRGB
    float normal_scale = 1.0f;
    float occlusion_strength = 1.0f;  ///< [0, 1]
};

struct Material {
    std::string name;
    glm::vec4 base_color{1.0f};                     ///< linear RGBA factor
    std::optional<std::uint32_t> base_color_image;  ///< index into Scene::images, addressed with uv, repeat wrap
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    // What only metallic-roughness shading looks at.
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;  ///< of the base colour's image
    float metallic = 0.0f, roughness = 0.5f;            ///< [0, 1]
    glm::vec3 emissive{0.0f};                           ///< linear
    bool unlit = false;                                 ///< KHR_materials_unlit: the base colour is what is seen
    Maps maps;
};

/// A light of KHR_lights_punctual, in world space.
struct Light {
    enum class Kind { directional, point, spot };
    Kind kind = Kind::directional;
    bool fixed_to_camera = false;                 ///< directional: the direction is one of camera space
    glm::vec3 direction{0.0f, 0.0f, 1.0f};        ///< unit: directional towards the light, spot the way it shines
    glm::vec3 place{0.0f};                        ///< of the others
    glm::vec3 intensity{1.0f};                    ///< colour times lux (directional) or candela
    float range = 0.0f;                           ///< where it ends; 0 for nowhere
    float cone_scale = 0.0f, cone_offset = 1.0f;  ///< of a spot, as the extension's formula for attenuation has them
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
    /// Shape factors of Phong tessellation in [0, 1]: one per position, or none at all.
    std::vector<float> alphas;
    /// Tags of scalar tagged PN triangles, sharpness in [0, 1], bias and tension in [-1, 1]: one per position, or none.
    std::vector<glm::vec3> stpn;
    /// Linear RGBA in [0, 1]: what the base colour is multiplied by. One per position, or none.
    std::vector<glm::vec4> colors;
    /// Unit tangents x, y, z with handedness w (1 or -1) for a normal map: its green points along w * cross(normal,
    /// tangent). One per position, or none.
    std::vector<glm::vec4> tangents;
    SubdivisionTags tags;
};

/// The width of a guide's point where the file gives none.
inline constexpr float no_width = -1.0f;

/// Guide curves of hair: the line strips of one node that share a material. Each curve runs from its root to its tip;
/// it has at least two points, no two neighbouring ones equal, and all numbers are finite.
struct Guides {
    std::string name;
    std::vector<glm::vec3> points;    ///< world space, curve after curve, roots first
    std::vector<glm::vec3> normals;   ///< unit, one per point; zero where the file has none
    std::vector<float> widths;        ///< full width of hair in world space, one per point; no_width without _WIDTH
    std::vector<std::uint32_t> ends;  ///< where each curve ends in `points`; the next one begins there
    std::uint32_t material = 0;       ///< index into Scene::materials; double-sided
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
    std::vector<Guides> guides;       ///< likewise
    std::vector<Material> materials;  ///< at least one
    std::vector<SceneImage> images;
    std::vector<Camera> cameras;        ///< in node order
    std::vector<Light> lights;          ///< likewise; only with LoadOptions::all_maps
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
    /// Loads what metallic-roughness shading needs besides the base colours: the other maps, factors and the lights.
    bool all_maps = false;
};

/// Loads `name`: a .gltf or .glb file (glTF 2.0), a .obj file (Wavefront, polygons), or a built-in shape (see
/// shapes.hpp): `shape:icosahedron`, `shape:cube`, `shape:torus`, `shape:sphere:N` with N in [1, 256] segments per
/// quarter. Whether a glTF file is binary or text is told by its content.
///
/// glTF: nodes are baked into world space in double precision; skins and morph targets are taken in the file's rest
/// pose. Triangles that FB_ngon_encoding marks as two halves of a quad become a quad. Normals that the file gives are
/// kept (made unit); those it does not give are angle-weighted over all faces of the node at the same position. Left
/// out, counted in messages: triangles that name a vertex twice or have a position that is not finite. Kept, and
/// counted: triangles without area, edges of more than two faces of a node, vertices that no triangle uses. Line
/// strips, and lines whose segments follow one another, are guide curves of hair; their full width is the attribute
/// _WIDTH (a float each, in the mesh's units), and their normals, where given, shade the hair.
///
/// Attributes that shape the surface: `_ALPHA` (SCALAR) is Phong tessellation's alpha of each vertex, `_STPN` (VEC3)
/// sharpness, bias and tension of scalar tagged PN triangles; floats, or integers that are normalised or not. A number
/// `alpha` in the `extras` of a glTF mesh holds for those of its primitives that have no `_ALPHA`. Values out of range
/// are clamped, values that are not finite become zero, and messages count them.
///
/// `COLOR_0` is kept as linear vertex colours, `TANGENT` as the frames of normal maps; where one of a primitive's
/// tangents is of no use, all of them are left out, with a message.
///
/// OBJ: see load_obj.hpp for the rules.
///
/// Points, line loops, animations and whatever else is not drawn are named in `messages`. A file that is sound but
/// holds neither faces nor guides gives an empty scene: whether that is an error is up to the caller. The limits on
/// sizes are those of limits.hpp.
///
/// Throws Error(usage) with file, element and reason for anything unsound or not supported.
Scene load_scene(const std::string& name, const LoadOptions& options = {});

}  // namespace tessera::scene
