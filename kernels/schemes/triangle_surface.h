// A triangle patch's control net in registers and the surface point that it gives: what the kernels of a degree and a
// kind of normals or tangents share. An including file names the struct by SURFACE and the function for a point by
// SURFACE_POINT and gives VERTICES_DEGREE (1..3) and VERTICES_NORMALS (0 none, 1 linear, 2 quadratic, 3 true). With
// normals there is the function SURFACE_VERTEX; without, SURFACE_FRAME, for SURFACE_TANGENTS (1 of the surface, 2 of
// its texture coordinates). No include guard: every variant includes it once.
#include "schemes/pattern_weights.h"
#include "schemes/surface_vertex.h"
#include "schemes/tangent_frame.h"

KERNELS_BEGIN

STRUCT(SURFACE) {
    Vector c0;
    Vector c1;
    Vector c2;
#if VERTICES_DEGREE == 2
    Vector c01;
    Vector c12;
    Vector c20;
#elif VERTICES_DEGREE == 3
    Vector c01;
    Vector c10;
    Vector c12;
    Vector c21;
    Vector c20;
    Vector c02;
    Vector centre;
#endif
#if VERTICES_NORMALS != 0
    Vector n0;
    Vector n1;
    Vector n2;
#endif
#if VERTICES_NORMALS == 2
    Vector n01;
    Vector n12;
    Vector n20;
#endif
    float s0;
    float t0;
    float s1;
    float t1;
    float s2;
    float t2;
};

#if VERTICES_DEGREE == 1
#define LOAD_MIXED_POINTS(net, nets, at)
#elif VERTICES_DEGREE == 2
#define LOAD_MIXED_POINTS(net, nets, at)     \
    net.c01 = LOAD_VECTOR(nets, (at) + 9u);  \
    net.c12 = LOAD_VECTOR(nets, (at) + 12u); \
    net.c20 = LOAD_VECTOR(nets, (at) + 15u);
#else
#define LOAD_MIXED_POINTS(net, nets, at)     \
    net.c01 = LOAD_VECTOR(nets, (at) + 9u);  \
    net.c10 = LOAD_VECTOR(nets, (at) + 12u); \
    net.c12 = LOAD_VECTOR(nets, (at) + 15u); \
    net.c21 = LOAD_VECTOR(nets, (at) + 18u); \
    net.c20 = LOAD_VECTOR(nets, (at) + 21u); \
    net.c02 = LOAD_VECTOR(nets, (at) + 24u); \
    net.centre = LOAD_VECTOR(nets, (at) + 27u);
#endif
#if VERTICES_NORMALS == 2
#define NET_NORMAL_POINTS 6u
#define LOAD_MIXED_NORMALS(net, nets, at)    \
    net.n01 = LOAD_VECTOR(nets, (at) + 9u);  \
    net.n12 = LOAD_VECTOR(nets, (at) + 12u); \
    net.n20 = LOAD_VECTOR(nets, (at) + 15u);
#else
#define NET_NORMAL_POINTS 3u
#define LOAD_MIXED_NORMALS(net, nets, at)
#endif
#define NET_NORMALS_AT (3u * NET_POINTS(VERTICES_DEGREE))
#define NET_UVS_AT (NET_NORMALS_AT + 3u * NET_NORMAL_POINTS)
#define LOAD_POINTS(net, nets, at)         \
    net.c0 = LOAD_VECTOR(nets, at);        \
    net.c1 = LOAD_VECTOR(nets, (at) + 3u); \
    net.c2 = LOAD_VECTOR(nets, (at) + 6u); \
    LOAD_MIXED_POINTS(net, nets, at)
#define LOAD_UVS(net, nets, at) \
    net.s0 = nets[at];          \
    net.t0 = nets[(at) + 1u];   \
    net.s1 = nets[(at) + 2u];   \
    net.t1 = nets[(at) + 3u];   \
    net.s2 = nets[(at) + 4u];   \
    net.t2 = nets[(at) + 5u]
#define LOAD_SURFACE(net, nets, at)                         \
    LOAD_POINTS(net, nets, at)                              \
    net.n0 = LOAD_VECTOR(nets, (at) + NET_NORMALS_AT);      \
    net.n1 = LOAD_VECTOR(nets, (at) + NET_NORMALS_AT + 3u); \
    net.n2 = LOAD_VECTOR(nets, (at) + NET_NORMALS_AT + 6u); \
    LOAD_MIXED_NORMALS(net, nets, (at) + NET_NORMALS_AT)    \
    LOAD_UVS(net, nets, (at) + NET_UVS_AT)

/// Where the surface is; and, where a kernel needs them, its derivatives along the domain's u and v (w falls as either
/// grows), a positive factor of both left out.
FUNCTION SurfacePoint SURFACE_POINT(SURFACE net, Barycentric b) {
    SurfacePoint p;
#if VERTICES_DEGREE == 1
    p.position = evaluate_linear(b, net.c0, net.c1, net.c2);
#elif VERTICES_DEGREE == 2
    p.position = evaluate_quadratic(quadratic_weights(b, 2.0f), net.c0, net.c1, net.c2, net.c01, net.c12, net.c20);
#else
    p.position = evaluate_cubic(cubic_weights(b), net.c0, net.c1, net.c2, net.c01, net.c10, net.c12, net.c21, net.c20,
                                net.c02, net.centre);
#endif
#if VERTICES_NORMALS == 1 || VERTICES_NORMALS == 2
    p.by_u = make_vector(0.0f, 0.0f, 0.0f);
    p.by_v = p.by_u;
#elif VERTICES_DEGREE == 1
    p.by_u = subtract(net.c0, net.c2);
    p.by_v = subtract(net.c1, net.c2);
#elif VERTICES_DEGREE == 2
    const Vector at2 = evaluate_linear(b, net.c20, net.c12, net.c2);
    p.by_u = subtract(evaluate_linear(b, net.c0, net.c01, net.c20), at2);
    p.by_v = subtract(evaluate_linear(b, net.c01, net.c1, net.c12), at2);
#else
    const QuadraticWeights q = quadratic_weights(b, 2.0f);
    const Vector at2 = evaluate_quadratic(q, net.c02, net.c12, net.c2, net.centre, net.c21, net.c20);
    p.by_u = subtract(evaluate_quadratic(q, net.c0, net.c10, net.c20, net.c01, net.centre, net.c02), at2);
    p.by_v = subtract(evaluate_quadratic(q, net.c01, net.c1, net.c21, net.c10, net.c12, net.centre), at2);
#endif
    return p;
}

#if VERTICES_DEGREE == 3 && VERTICES_NORMALS == 2
// The scheme that is used most blends with weights that a pattern may bring along.
#define SURFACE_HAS_WEIGHTS 1
FUNCTION SurfaceVertex SURFACE_WEIGHTED(SURFACE net, PatternWeights w) {
    const Vector position =
        evaluate_cubic(w.c, net.c0, net.c1, net.c2, net.c01, net.c10, net.c12, net.c21, net.c20, net.c02, net.centre);
    const Vector normal = blended_normal(evaluate_quadratic(w.q, net.n0, net.n1, net.n2, net.n01, net.n12, net.n20));
    return make_surface_vertex(position, normal, blend_linear(w.b, net.s0, net.s1, net.s2),
                               blend_linear(w.b, net.t0, net.t1, net.t2));
}

// Not a function, for g++ does not vectorise what hands a net on.
#undef SURFACE_VERTEX
#define SURFACE_VERTEX(net, point) SURFACE_WEIGHTED(net, pattern_weights((point).u, (point).v))
#elif VERTICES_NORMALS != 0
FUNCTION SurfaceVertex SURFACE_VERTEX(SURFACE net, DomainPoint point) {
    const Barycentric b = make_barycentric(point.u, point.v);
    const SurfacePoint p = SURFACE_POINT(net, b);
#if VERTICES_NORMALS == 2
    const Vector normal = blended_normal(
        evaluate_quadratic(quadratic_weights(b, 1.0f), net.n0, net.n1, net.n2, net.n01, net.n12, net.n20));
#else
    const Vector blended = blended_normal(evaluate_linear(b, net.n0, net.n1, net.n2));
#endif
#if VERTICES_NORMALS == 1
    const Vector normal = blended;
#elif VERTICES_NORMALS == 3
    const Vector normal = true_normal(p.by_u, p.by_v, blended);
#endif
    return make_surface_vertex(p.position, normal, blend_linear(b, net.s0, net.s1, net.s2),
                               blend_linear(b, net.t0, net.t1, net.t2));
}
#else
/// `normal` is the vertex's, unit.
FUNCTION TangentFrame SURFACE_FRAME(SURFACE net, DomainPoint point, Vector normal) {
    const SurfacePoint p = SURFACE_POINT(net, make_barycentric(point.u, point.v));
#if SURFACE_TANGENTS == 1
    return make_frame(p.by_u, p.by_v, normal);
#else
    const TextureSlope s = make_texture_slope(texture_step(net.s2, net.s0), texture_step(net.s2, net.s1));
    const TextureSlope t = make_texture_slope(texture_step(net.t2, net.t0), texture_step(net.t2, net.t1));
    return make_texture_frame(p.by_u, p.by_v, s, t, normal);
#endif
}
#endif

KERNELS_END
