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

/// A place on a surface and the surface's derivatives there.
STRUCT(SurfacePoint) {
    Vector position;
    Vector by_u;
    Vector by_v;
};

/// A blend of unit normals, of length 4 at most, made unit length. Opposite normals may cancel; what is then returned
/// is the same from every patch.
FUNCTION Vector blended_normal(Vector blend) {
    const Vector v = flush_vector(blend);  // squares are 0 or at least 2^-120 now
    const float length_squared = dot_product(v, v);
    const Vector unit = scale(v, exact_rsqrt_of_normal(length_squared));
    const bool ok = length_squared > 0.0f;
    return make_vector(ok ? unit.x : 0.0f, ok ? unit.y : 0.0f, ok ? unit.z : 1.0f);
}

/// The surface's own normal from its derivatives, of any length; `fallback` where they vanish or are parallel.
FUNCTION Vector true_normal(Vector by_u, Vector by_v, Vector fallback) {
    return normalise(cross_product(normalise_exponent(by_u), normalise_exponent(by_v)), fallback);
}

/// Makes sure that no denormal and no negative zero leaves. The normal is one of the above.
FUNCTION SurfaceVertex make_surface_vertex(Vector position, Vector normal, float s, float t) {
    SurfaceVertex vertex;
    vertex.position = flush_vector(position);
    vertex.normal = normal;
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

/// As vertex k of an array that holds RUN of each word.
#define PUT_INTO_RUN(run, k, v)           \
    run[k] = (v).position.x;              \
    run[RUN + (k)] = (v).position.y;      \
    run[2u * RUN + (k)] = (v).position.z; \
    run[3u * RUN + (k)] = (v).normal.x;   \
    run[4u * RUN + (k)] = (v).normal.y;   \
    run[5u * RUN + (k)] = (v).normal.z;   \
    run[6u * RUN + (k)] = (v).s;          \
    run[7u * RUN + (k)] = (v).t

KERNELS_END

#endif
