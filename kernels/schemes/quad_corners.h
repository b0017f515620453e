// What every scheme for quads starts from.
//
//   3 ---- 2    Corners in the order of the face; u runs from 0 to 1, v from 0 to 3. Edge points are named as in
//   triangles: |      |    c01 lies next to corner 0, towards 1. 0 ---- 1
#ifndef TESSERA_SCHEMES_QUAD_CORNERS_H
#define TESSERA_SCHEMES_QUAD_CORNERS_H

#include "schemes/corners.h"

KERNELS_BEGIN

/// The corners of a quad patch: positions in [-2, 2], unit normals.
STRUCT(QuadCorners) {
    Vector p0;
    Vector p1;
    Vector p2;
    Vector p3;
    Vector n0;
    Vector n1;
    Vector n2;
    Vector n3;
};

/// Loads the corners of a patch from the buffers of control vertices and patch indices.
#define LOAD_QUAD_CORNERS(corners, control_vertices, i0, i1, i2, i3)     \
    corners.p0 = LOAD_VECTOR(control_vertices, (i0)*VERTEX_FLOATS);      \
    corners.p1 = LOAD_VECTOR(control_vertices, (i1)*VERTEX_FLOATS);      \
    corners.p2 = LOAD_VECTOR(control_vertices, (i2)*VERTEX_FLOATS);      \
    corners.p3 = LOAD_VECTOR(control_vertices, (i3)*VERTEX_FLOATS);      \
    corners.n0 = LOAD_VECTOR(control_vertices, (i0)*VERTEX_FLOATS + 3u); \
    corners.n1 = LOAD_VECTOR(control_vertices, (i1)*VERTEX_FLOATS + 3u); \
    corners.n2 = LOAD_VECTOR(control_vertices, (i2)*VERTEX_FLOATS + 3u); \
    corners.n3 = LOAD_VECTOR(control_vertices, (i3)*VERTEX_FLOATS + 3u)

KERNELS_END

#endif
