// A vertex as the emitting kernels write it.
#ifndef TESSERA_SCHEMES_SURFACE_VERTEX_H
#define TESSERA_SCHEMES_SURFACE_VERTEX_H

#include "layout.h"
#include "vector.h"

KERNELS_BEGIN

STRUCT(SurfaceVertex) {
    Vector position;
    Vector normal;
    float s;
    float t;
};

/// Normalises the blended normal; opposite normals may cancel, and the fallback is the same from every patch. Makes
/// sure that no denormal and no negative zero leaves.
FUNCTION SurfaceVertex make_surface_vertex(Vector position, Vector blended_normal, float s, float t) {
    SurfaceVertex vertex;
    vertex.position = flush_vector(position);
    vertex.normal = normalise(blended_normal, make_vector(0.0f, 0.0f, 1.0f));
    vertex.s = flush_tiny(s);
    vertex.t = flush_tiny(t);
    return vertex;
}

#define STORE_SURFACE_VERTEX(buffer, at, v) \
    buffer[at] = (v).position.x;            \
    buffer[(at) + 1u] = (v).position.y;     \
    buffer[(at) + 2u] = (v).position.z;     \
    buffer[(at) + 3u] = (v).normal.x;       \
    buffer[(at) + 4u] = (v).normal.y;       \
    buffer[(at) + 5u] = (v).normal.z;       \
    buffer[(at) + 6u] = (v).s;              \
    buffer[(at) + 7u] = (v).t

KERNELS_END

#endif
