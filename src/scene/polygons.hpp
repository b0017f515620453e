// Faces of any number of corners over pools of positions, texture coordinates and normals, as OBJ files have them.
#pragma once

#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace tessera::scene {

inline constexpr std::uint32_t no_index = 0xffffffff;

struct Corner {
    std::uint32_t position = 0;
    std::uint32_t uv = no_index;
    std::uint32_t normal = no_index;
};

struct Polygon {
    std::uint64_t first = 0;  ///< corner; counter-clockwise from here
    std::uint32_t count = 0;
    std::uint32_t part = 0;
    std::uint32_t smoothing = 0;  ///< group; 0 is flat
    std::uint32_t number = 0;     ///< of the file's face
};

/// Faces of one object, group and material.
struct PolygonPart {
    std::string name;
    std::string material;              ///< empty without one
    std::vector<std::uint32_t> holes;  ///< faces left out, by number
};

struct Polygons {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec2> uvs;
    std::vector<glm::vec3> normals;  ///< unit, or zero where the file's is of no use
    std::vector<Corner> corners;
    std::vector<Polygon> faces;
    std::vector<PolygonPart> parts;
    SubdivisionTags tags;  ///< in terms of `positions`; holes are with the parts

    std::span<Corner> corners_of(const Polygon& face) { return {corners.data() + face.first, face.count}; }
    std::span<const Corner> corners_of(const Polygon& face) const { return {corners.data() + face.first, face.count}; }
};

/// An edge between two positions, whichever way round, as one number.
inline std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
    return a < b ? (std::uint64_t{a} << 32) | b : (std::uint64_t{b} << 32) | a;
}

/// Twice the vector area of a face (Newell's method, taken about its first corner): the normal of the plane that fits
/// best. Zero where the face has no area.
glm::dvec3 vector_area(const Polygons& polygons, const Polygon& face);

/// Splits every face of n corners into n quads as Catmull-Clark does, positions linear: corner, middle of the next
/// edge, mean of all corners, middle of the edge before. Texture coordinates and normals (made unit) likewise. Middles
/// are the same bits from either side. A crease becomes two, both as sharp.
void split_polygons(Polygons& polygons);

/// Cuts faces of more than four corners into triangles: ear clipping (Meisters 1975) in the plane that fits best, so
/// that concave ones and ones with a bridge to a hole come out right. A face that has no ear is cut anyway, somehow.
/// With `only_hidden`, just those of which is_star_shaped says no.
void fan_polygons(Polygons& polygons, bool only_hidden = false);

/// True if the mean of the corners sees every edge of the face from inside (in the plane that fits best), so that
/// splitting about it folds nothing over.
bool is_star_shaped(const Polygons& polygons, const Polygon& face);

/// Gives a normal to every corner that has none: in group 0 as flatten_normals, in others the angle-weighted mean over
/// the faces of the same group around the position. All faces must have three or four corners.
void complete_polygon_normals(Polygons& polygons);

/// Gives the faces of group 0 that have a corner without normal their own normal there.
void flatten_normals(Polygons& polygons);

}  // namespace tessera::scene
