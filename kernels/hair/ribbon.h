// From a line to a ribbon: the direction across a hair, its width there and the normals of its two edges.
// Source: the "expand lines to quads" stage of Ni, Efficient substitutes for subdivision surfaces in Direct3D 11, GDC
// 2010.
#ifndef TESSERA_HAIR_RIBBON_H
#define TESSERA_HAIR_RIBBON_H

#include "hair/guide_curve.h"
#include "schemes/surface_vertex.h"

KERNELS_BEGIN

// Squared sine under which two directions count as parallel: an angle of about a thousandth.
#define RIBBON_PARALLEL 0.00000095367431640625f

/// A direction with its largest component in [1, 2); `fallback` for zero.
FUNCTION Vector hair_direction(Vector v, Vector fallback) {
    const Vector d = flush_hair_vector(normalise_exponent(v));
    const bool none = dot_product(d, d) == 0.0f;
    return make_vector(none ? fallback.x : d.x, none ? fallback.y : d.y, none ? fallback.z : d.z);
}

/// A vector at right angles to a direction: across it and the axis that it is farthest from.
FUNCTION Vector any_perpendicular(Vector v) {
    const float x = v.x * v.x;
    const float y = v.y * v.y;
    const float z = v.z * v.z;
    const float least = x < y ? (x < z ? x : z) : (y < z ? y : z);
    return cross_product(v, make_vector(x == least ? 1.0f : 0.0f, x != least && y == least ? 1.0f : 0.0f,
                                        x != least && y != least ? 1.0f : 0.0f));
}

STRUCT(Ribbon) {
    Vector side;    // unit, across the hair to its right as seen from where it faces
    Vector facing;  // at right angles to side and hair, of any length
};

/// The ribbon of a hair through `position` along `tangent`. RIBBONS_CAMERA: it faces `target`, the eye. RIBBONS_FLAT:
/// its side is as near to the unit vector `target` as the hair allows. Where that leaves no direction (a hair seen end
/// on, a hair along the direction), any one at right angles to the hair. A tangent of zero counts as upward.
FUNCTION Ribbon make_ribbon(Vector position, Vector tangent, uint ribbons, Vector target) {
    const Vector along = hair_direction(tangent, make_vector(0.0f, 1.0f, 0.0f));
    const bool camera = ribbons == RIBBONS_CAMERA;
    const Vector sight =
        make_vector(camera ? target.x - position.x : target.x, camera ? target.y - position.y : target.y,
                    camera ? target.z - position.z : target.z);
    const Vector towards = hair_direction(sight, make_vector(0.0f, 0.0f, 1.0f));
    const float square = dot_product(along, along);
    const float share = flush_hair(dot_product(along, towards));
    const Vector off_eye = cross_product(along, towards);
    const Vector off_direction = subtract(scale(towards, square), scale(along, share));
    const Vector across =
        flush_hair_vector(make_vector(camera ? off_eye.x : off_direction.x, camera ? off_eye.y : off_direction.y,
                                      camera ? off_eye.z : off_direction.z));
    const float limit = RIBBON_PARALLEL * (square * dot_product(towards, towards));
    const bool parallel = dot_product(across, across) < limit;
    const Vector other = any_perpendicular(along);
    Ribbon ribbon;
    ribbon.side = flush_hair_vector(normalise(
        make_vector(parallel ? other.x : across.x, parallel ? other.y : across.y, parallel ? other.z : across.z),
        make_vector(1.0f, 0.0f, 0.0f)));
    ribbon.facing = flush_hair_vector(cross_product(ribbon.side, along));
    return ribbon;
}

/// Half the width of a hair at u (16.16): linear from the root to the share 1 - taper at the tip.
FUNCTION float ribbon_half_width(float width, float taper, uint u) {
    const float left = 1.0f - taper * (to_float(u) * 0.0000152587890625f);
    return flush_hair((0.5f * width) * left);
}

/// The unit normal of a hair: the guides' where they have one, else the ribbon's.
FUNCTION Vector hair_normal(Vector of_guides, Vector facing) {
    const bool none = dot_product(of_guides, of_guides) == 0.0f;
    return flush_hair_vector(normalise(
        make_vector(none ? facing.x : of_guides.x, none ? facing.y : of_guides.y, none ? facing.z : of_guides.z),
        make_vector(0.0f, 0.0f, 1.0f)));
}

/// One edge of a ribbon: to its right for `side` 1, to its left for -1. Its shading normal is that of half a cylinder
/// around the hair's, 45 degrees to either side.
FUNCTION SurfaceVertex ribbon_vertex(Vector position, Vector reach, Vector normal, Vector side, float which,
                                     float along) {
    return make_surface_vertex(add(position, scale(reach, which)), blended_normal(add(normal, scale(side, which))),
                               0.5f + 0.5f * which, along);
}

KERNELS_END

#endif
