// A triangle patch's control net in registers and the surface point that it gives: what the kernels of a degree and a
// kind of normals share. An including file names the struct by SURFACE and the function by SURFACE_VERTEX and gives
// VERTICES_DEGREE (1..3) and VERTICES_NORMALS (1 linear, 2 quadratic, 3 true). No include guard: every variant includes
// it once.
#include "schemes/basis.h"
#include "schemes/surface_vertex.h"

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
    Vector n0;
    Vector n1;
    Vector n2;
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
#define LOAD_SURFACE(net, nets, at)                         \
    net.c0 = LOAD_VECTOR(nets, at);                         \
    net.c1 = LOAD_VECTOR(nets, (at) + 3u);                  \
    net.c2 = LOAD_VECTOR(nets, (at) + 6u);                  \
    LOAD_MIXED_POINTS(net, nets, at)                        \
    net.n0 = LOAD_VECTOR(nets, (at) + NET_NORMALS_AT);      \
    net.n1 = LOAD_VECTOR(nets, (at) + NET_NORMALS_AT + 3u); \
    net.n2 = LOAD_VECTOR(nets, (at) + NET_NORMALS_AT + 6u); \
    LOAD_MIXED_NORMALS(net, nets, (at) + NET_NORMALS_AT)    \
    net.s0 = nets[(at) + NET_UVS_AT];                       \
    net.t0 = nets[(at) + NET_UVS_AT + 1u];                  \
    net.s1 = nets[(at) + NET_UVS_AT + 2u];                  \
    net.t1 = nets[(at) + NET_UVS_AT + 3u];                  \
    net.s2 = nets[(at) + NET_UVS_AT + 4u];                  \
    net.t2 = nets[(at) + NET_UVS_AT + 5u]

FUNCTION SurfaceVertex SURFACE_VERTEX(SURFACE net, DomainPoint point) {
    const Barycentric b = make_barycentric(point.u, point.v);
#if VERTICES_DEGREE == 1
    const Vector position = evaluate_linear(b, net.c0, net.c1, net.c2);
#elif VERTICES_DEGREE == 2
    const Vector position =
        evaluate_quadratic(quadratic_weights(b, 2.0f), net.c0, net.c1, net.c2, net.c01, net.c12, net.c20);
#else
    const Vector position = evaluate_cubic(cubic_weights(b), net.c0, net.c1, net.c2, net.c01, net.c10, net.c12, net.c21,
                                           net.c20, net.c02, net.centre);
#endif
#if VERTICES_NORMALS == 2
    const Vector normal = blended_normal(
        evaluate_quadratic(quadratic_weights(b, 1.0f), net.n0, net.n1, net.n2, net.n01, net.n12, net.n20));
#else
    const Vector blended = blended_normal(evaluate_linear(b, net.n0, net.n1, net.n2));
#endif
#if VERTICES_NORMALS == 1
    const Vector normal = blended;
#elif VERTICES_NORMALS == 3
#if VERTICES_DEGREE == 1
    const Vector by_u = subtract(net.c0, net.c2);
    const Vector by_v = subtract(net.c1, net.c2);
#elif VERTICES_DEGREE == 2
    const Vector at2 = evaluate_linear(b, net.c20, net.c12, net.c2);
    const Vector by_u = subtract(evaluate_linear(b, net.c0, net.c01, net.c20), at2);
    const Vector by_v = subtract(evaluate_linear(b, net.c01, net.c1, net.c12), at2);
#else
    const QuadraticWeights q = quadratic_weights(b, 2.0f);
    const Vector at2 = evaluate_quadratic(q, net.c02, net.c12, net.c2, net.centre, net.c21, net.c20);
    const Vector by_u = subtract(evaluate_quadratic(q, net.c0, net.c10, net.c20, net.c01, net.centre, net.c02), at2);
    const Vector by_v = subtract(evaluate_quadratic(q, net.c01, net.c1, net.c21, net.c10, net.c12, net.centre), at2);
#endif
    const Vector normal = true_normal(by_u, by_v, blended);
#endif
    return make_surface_vertex(position, normal, blend_linear(b, net.s0, net.s1, net.s2),
                               blend_linear(b, net.t0, net.t1, net.t2));
}

KERNELS_END
