// What shapes a surface at its control vertices and edges, beyond positions and normals.
#ifndef TESSERA_SCHEMES_TAGS_H
#define TESSERA_SCHEMES_TAGS_H

#include "schemes/corners.h"

KERNELS_BEGIN

/// Of a control vertex; equal wherever patches share it. No magnitude lies strictly between 0 and 2^-24.
STRUCT(VertexTags) {
    float sharpness;  // 0 .. 1
    float bias;       // -1 .. 1
    float tension;    // -1 .. 1
    float alpha;      // 0 .. 1, of Phong tessellation
    Vector crease;    // unit, along the crease that runs through the vertex; zero where none does or several meet
    Vector normal;    // unit, for creases that are not quite sharp: the same for both of their faces
};

#define LOAD_VERTEX_TAGS(tags, buffer, at)        \
    tags.sharpness = buffer[at];                  \
    tags.bias = buffer[(at) + 1u];                \
    tags.tension = buffer[(at) + 2u];             \
    tags.alpha = buffer[(at) + 3u];               \
    tags.crease = LOAD_VECTOR(buffer, (at) + 4u); \
    tags.normal = LOAD_VECTOR(buffer, (at) + 7u)

/// Of a patch's corner. The sharpness is 0 .. 1 and equal in both patches of the edge.
STRUCT(CornerTags) {
    Vector normal;
    float edge;  // sharpness of the edge to the next corner
};

#define LOAD_CORNER_TAGS(tags, buffer, at) \
    tags.normal = LOAD_VECTOR(buffer, at); \
    tags.edge = buffer[(at) + 3u]

KERNELS_END

#endif
