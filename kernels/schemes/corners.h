// What every scheme for triangles starts from, and the normals that every scheme shares.
#ifndef TESSERA_SCHEMES_CORNERS_H
#define TESSERA_SCHEMES_CORNERS_H

#include "layout.h"
#include "vector.h"

KERNELS_BEGIN

/// The corners of a triangle patch: positions in [-2, 2], unit normals.
STRUCT(Corners) {
    Vector p0;
    Vector p1;
    Vector p2;
    Vector n0;
    Vector n1;
    Vector n2;
};

/// Loads the corners of a patch from the buffers of control vertices and patch indices.
#define LOAD_CORNERS(corners, control_vertices, i0, i1, i2)              \
    corners.p0 = LOAD_VECTOR(control_vertices, (i0)*VERTEX_FLOATS);      \
    corners.p1 = LOAD_VECTOR(control_vertices, (i1)*VERTEX_FLOATS);      \
    corners.p2 = LOAD_VECTOR(control_vertices, (i2)*VERTEX_FLOATS);      \
    corners.n0 = LOAD_VECTOR(control_vertices, (i0)*VERTEX_FLOATS + 3u); \
    corners.n1 = LOAD_VECTOR(control_vertices, (i1)*VERTEX_FLOATS + 3u); \
    corners.n2 = LOAD_VECTOR(control_vertices, (i2)*VERTEX_FLOATS + 3u)

/// The normal coefficient of the edge between two corners, for normals that vary quadratically: the sum of the two
/// normals reflected in the plane perpendicular to the edge, then made unit length (Vlachos et al. 2001, section 3.3;
/// v_ij carries a factor of 2). The same bits from either side. A zero edge gives the normalised sum, opposite normals
/// the zero vector.
FUNCTION Vector edge_normal(Vector pa, Vector na, Vector pb, Vector nb) {
    const Vector d = normalise_exponent(subtract(pb, pa));
    const Vector sum = add(na, nb);
    const float length_squared = dot_product(d, d);
    const float twice = 2.0f * dot_product(d, sum);
    const float v = length_squared > 0.0f ? exact_divide(twice, length_squared) : 0.0f;
    return normalise(subtract(sum, scale(d, v)), make_vector(0.0f, 0.0f, 0.0f));
}

KERNELS_END

#endif
