// From a line to a ribbon: the direction across a hair, its width there and the normals of its two edges.
// Source: the "expand lines to quads" stage of Ni, Efficient substitutes for subdivision surfaces in Direct3D 11, GDC
// 2010.
#ifndef TESSERA_HAIR_RIBBON_H
#define TESSERA_HAIR_RIBBON_H

#include "hair/guide_curve.h"

KERNELS_BEGIN

// Squared sine under which two unit vectors count as parallel: an angle of about a thousandth.
#define RIBBON_PARALLEL 0.00000095367431640625f

FUNCTION Vector cross_product(Vector a, Vector b) {
    return make_vector(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

FUNCTION Vector hair_unit(Vector v, Vector fallback) {
    return flush_hair_vector(normalise(v, fallback));
}

FUNCTION Vector choose_vector(bool choice, Vector yes, Vector no) {
    return make_vector(choice ? yes.x : no.x, choice ? yes.y : no.y, choice ? yes.z : no.z);
}

/// A unit vector at right angles to a unit vector: across it and the axis that it is farthest from.
FUNCTION Vector any_perpendicular(Vector unit) {
    const uint x = float_bits(unit.x) & 0x7fffffffu;
    const uint y = float_bits(unit.y) & 0x7fffffffu;
    const uint z = float_bits(unit.z) & 0x7fffffffu;
    const bool is_x = x <= y && x <= z;
    const bool is_y = !is_x && y <= z;
    const Vector axis = make_vector(is_x ? 1.0f : 0.0f, is_y ? 1.0f : 0.0f, is_x || is_y ? 0.0f : 1.0f);
    return hair_unit(cross_product(unit, axis), axis);
}

STRUCT(Ribbon) {
    Vector side;    // unit, across the hair to its right as seen from where it faces
    Vector facing;  // unit, at right angles to side and hair
};

/// The ribbon of a hair through `position` along `tangent`. RIBBONS_CAMERA: it faces `target`, the eye. RIBBONS_FLAT:
/// its side is as near to the unit vector `target` as the hair allows. Where that leaves no direction (a hair seen end
/// on, a hair along the direction), any one at right angles to the hair. A tangent of zero counts as upward.
FUNCTION Ribbon make_ribbon(Vector position, Vector tangent, uint ribbons, Vector target) {
    const Vector along = hair_unit(tangent, make_vector(0.0f, 1.0f, 0.0f));
    const Vector to_eye = hair_unit(subtract(target, position), make_vector(0.0f, 0.0f, 1.0f));
    const float share = flush_hair(dot_product(along, target));
    const Vector off_eye = cross_product(along, to_eye);
    const Vector off_direction = subtract(target, scale(along, share));
    const Vector across = flush_hair_vector(choose_vector(ribbons == RIBBONS_CAMERA, off_eye, off_direction));
    const bool parallel = dot_product(across, across) < RIBBON_PARALLEL;
    const Vector other = any_perpendicular(along);
    Ribbon ribbon;
    ribbon.side = hair_unit(choose_vector(parallel, other, across), other);
    ribbon.facing = hair_unit(cross_product(ribbon.side, along), make_vector(0.0f, 0.0f, 1.0f));
    return ribbon;
}

/// Half the width of a hair at u (16.16): linear from the root to the share 1 - taper at the tip.
FUNCTION float ribbon_half_width(float width, float taper, uint u) {
    const float left = 1.0f - taper * (to_float(u) * 0.0000152587890625f);
    return flush_hair((0.5f * width) * left);
}

/// Shading normals of the two edges: those of half a cylinder around `normal`, 45 degrees to either side.
FUNCTION Vector ribbon_normal(Vector normal, Vector side, Vector facing) {
    return normalise(flush_hair_vector(add(normal, side)), facing);
}

KERNELS_END

#endif
