// A quad patch's control net in registers and the surface point that it gives; otherwise as triangle_surface.h. No
// include guard: every variant includes it once.
#include "schemes/quad_basis.h"
#include "schemes/surface_vertex.h"
#include "schemes/tangent_frame.h"

KERNELS_BEGIN

STRUCT(SURFACE) {
    Vector c0;
    Vector c1;
    Vector c2;
    Vector c3;
#if VERTICES_DEGREE == 2
    Vector c01;
    Vector c12;
    Vector c23;
    Vector c30;
    Vector centre;
#elif VERTICES_DEGREE == 3
    Vector c01;
    Vector c10;
    Vector c12;
    Vector c21;
    Vector c23;
    Vector c32;
    Vector c30;
    Vector c03;
    Vector inner0;
    Vector inner1;
    Vector inner2;
    Vector inner3;
#endif
#if VERTICES_NORMALS != 0
    Vector n0;
    Vector n1;
    Vector n2;
    Vector n3;
#endif
#if VERTICES_NORMALS == 2
    Vector n01;
    Vector n12;
    Vector n23;
    Vector n30;
    Vector middle;
#endif
    float s0;
    float t0;
    float s1;
    float t1;
    float s2;
    float t2;
    float s3;
    float t3;
};

#if VERTICES_DEGREE == 1
#define LOAD_MIXED_POINTS(net, nets, at)
#elif VERTICES_DEGREE == 2
#define LOAD_MIXED_POINTS(net, nets, at)     \
    net.c01 = LOAD_VECTOR(nets, (at) + 12u); \
    net.c12 = LOAD_VECTOR(nets, (at) + 15u); \
    net.c23 = LOAD_VECTOR(nets, (at) + 18u); \
    net.c30 = LOAD_VECTOR(nets, (at) + 21u); \
    net.centre = LOAD_VECTOR(nets, (at) + 24u);
#else
#define LOAD_MIXED_POINTS(net, nets, at)        \
    net.c01 = LOAD_VECTOR(nets, (at) + 12u);    \
    net.c10 = LOAD_VECTOR(nets, (at) + 15u);    \
    net.c12 = LOAD_VECTOR(nets, (at) + 18u);    \
    net.c21 = LOAD_VECTOR(nets, (at) + 21u);    \
    net.c23 = LOAD_VECTOR(nets, (at) + 24u);    \
    net.c32 = LOAD_VECTOR(nets, (at) + 27u);    \
    net.c30 = LOAD_VECTOR(nets, (at) + 30u);    \
    net.c03 = LOAD_VECTOR(nets, (at) + 33u);    \
    net.inner0 = LOAD_VECTOR(nets, (at) + 36u); \
    net.inner1 = LOAD_VECTOR(nets, (at) + 39u); \
    net.inner2 = LOAD_VECTOR(nets, (at) + 42u); \
    net.inner3 = LOAD_VECTOR(nets, (at) + 45u);
#endif
#if VERTICES_NORMALS == 2
#define NET_NORMAL_POINTS 9u
#define LOAD_MIXED_NORMALS(net, nets, at)    \
    net.n01 = LOAD_VECTOR(nets, (at) + 12u); \
    net.n12 = LOAD_VECTOR(nets, (at) + 15u); \
    net.n23 = LOAD_VECTOR(nets, (at) + 18u); \
    net.n30 = LOAD_VECTOR(nets, (at) + 21u); \
    net.middle = LOAD_VECTOR(nets, (at) + 24u);
#else
#define NET_NORMAL_POINTS 4u
#define LOAD_MIXED_NORMALS(net, nets, at)
#endif
#define NET_NORMALS_AT (3u * QUAD_NET_POINTS(VERTICES_DEGREE))
#define NET_UVS_AT (NET_NORMALS_AT + 3u * NET_NORMAL_POINTS)
#define LOAD_POINTS(net, nets, at)         \
    net.c0 = LOAD_VECTOR(nets, at);        \
    net.c1 = LOAD_VECTOR(nets, (at) + 3u); \
    net.c2 = LOAD_VECTOR(nets, (at) + 6u); \
    net.c3 = LOAD_VECTOR(nets, (at) + 9u); \
    LOAD_MIXED_POINTS(net, nets, at)
#define LOAD_UVS(net, nets, at) \
    net.s0 = nets[at];          \
    net.t0 = nets[(at) + 1u];   \
    net.s1 = nets[(at) + 2u];   \
    net.t1 = nets[(at) + 3u];   \
    net.s2 = nets[(at) + 4u];   \
    net.t2 = nets[(at) + 5u];   \
    net.s3 = nets[(at) + 6u];   \
    net.t3 = nets[(at) + 7u]
#define LOAD_SURFACE(net, nets, at)                         \
    LOAD_POINTS(net, nets, at)                              \
    net.n0 = LOAD_VECTOR(nets, (at) + NET_NORMALS_AT);      \
    net.n1 = LOAD_VECTOR(nets, (at) + NET_NORMALS_AT + 3u); \
    net.n2 = LOAD_VECTOR(nets, (at) + NET_NORMALS_AT + 6u); \
    net.n3 = LOAD_VECTOR(nets, (at) + NET_NORMALS_AT + 9u); \
    LOAD_MIXED_NORMALS(net, nets, (at) + NET_NORMALS_AT)    \
    LOAD_UVS(net, nets, (at) + NET_UVS_AT)

FUNCTION SurfacePoint SURFACE_POINT(SURFACE net, DomainPoint point) {
#if VERTICES_DEGREE == 1 || (VERTICES_DEGREE == 2 && (VERTICES_NORMALS == 0 || VERTICES_NORMALS == 3))
    const CurveWeights u = curve_weights_linear(point.u);
    const CurveWeights v = curve_weights_linear(point.v);
#endif
    SurfacePoint p;
#if VERTICES_DEGREE == 1
    p.position = evaluate_bilinear(u, v, net.c0, net.c1, net.c2, net.c3);
#elif VERTICES_DEGREE == 2
    p.position = evaluate_biquadratic(curve_weights_quadratic(point.u, 2.0f), curve_weights_quadratic(point.v, 2.0f),
                                      net.c0, net.c1, net.c2, net.c3, net.c01, net.c12, net.c23, net.c30, net.centre);
#else
    const CurveWeights cubic_u = curve_weights_cubic(point.u);
    const CurveWeights cubic_v = curve_weights_cubic(point.v);
    const Vector column0 = column_cubic(cubic_v, net.c0, net.c03, net.c30, net.c3);
    const Vector column1 = column_cubic(cubic_v, net.c01, net.inner0, net.inner3, net.c32);
    const Vector column2 = column_cubic(cubic_v, net.c10, net.inner1, net.inner2, net.c23);
    const Vector column3 = column_cubic(cubic_v, net.c1, net.c12, net.c21, net.c2);
    p.position = column_cubic(cubic_u, column0, column1, column2, column3);
#endif
#if VERTICES_NORMALS == 1 || VERTICES_NORMALS == 2
    p.by_u = make_vector(0.0f, 0.0f, 0.0f);
    p.by_v = p.by_u;
#elif VERTICES_DEGREE == 1
    p.by_u = line_point(v, subtract(net.c1, net.c0), subtract(net.c2, net.c3));
    p.by_v = line_point(u, subtract(net.c3, net.c0), subtract(net.c2, net.c1));
#elif VERTICES_DEGREE == 2
    const CurveWeights quadratic_u = curve_weights_quadratic(point.u, 2.0f);
    const CurveWeights quadratic_v = curve_weights_quadratic(point.v, 2.0f);
    const Vector column0 = column_quadratic(quadratic_v, net.c0, net.c30, net.c3);
    const Vector column1 = column_quadratic(quadratic_v, net.c01, net.centre, net.c23);
    const Vector column2 = column_quadratic(quadratic_v, net.c1, net.c12, net.c2);
    p.by_u = line_point(u, subtract(column1, column0), subtract(column2, column1));
    const Vector row0 = column_quadratic(quadratic_u, net.c0, net.c01, net.c1);
    const Vector row1 = column_quadratic(quadratic_u, net.c30, net.centre, net.c12);
    const Vector row2 = column_quadratic(quadratic_u, net.c3, net.c23, net.c2);
    p.by_v = line_point(v, subtract(row1, row0), subtract(row2, row1));
#else
    p.by_u = column_quadratic(curve_weights_quadratic(point.u, 2.0f), subtract(column1, column0),
                              subtract(column2, column1), subtract(column3, column2));
    const Vector row0 = column_cubic(cubic_u, net.c0, net.c01, net.c10, net.c1);
    const Vector row1 = column_cubic(cubic_u, net.c03, net.inner0, net.inner1, net.c12);
    const Vector row2 = column_cubic(cubic_u, net.c30, net.inner3, net.inner2, net.c21);
    const Vector row3 = column_cubic(cubic_u, net.c3, net.c32, net.c23, net.c2);
    p.by_v = column_quadratic(curve_weights_quadratic(point.v, 2.0f), subtract(row1, row0), subtract(row2, row1),
                              subtract(row3, row2));
#endif
    return p;
}

#if VERTICES_NORMALS != 0
FUNCTION SurfaceVertex SURFACE_VERTEX(SURFACE net, DomainPoint point) {
    const CurveWeights u = curve_weights_linear(point.u);
    const CurveWeights v = curve_weights_linear(point.v);
    const SurfacePoint p = SURFACE_POINT(net, point);
#if VERTICES_NORMALS == 2
    const Vector normal = blended_normal(
        evaluate_biquadratic(curve_weights_quadratic(point.u, 1.0f), curve_weights_quadratic(point.v, 1.0f), net.n0,
                             net.n1, net.n2, net.n3, net.n01, net.n12, net.n23, net.n30, net.middle));
#else
    const Vector blended = blended_normal(evaluate_bilinear(u, v, net.n0, net.n1, net.n2, net.n3));
#endif
#if VERTICES_NORMALS == 1
    const Vector normal = blended;
#elif VERTICES_NORMALS == 3
    const Vector normal = true_normal(p.by_u, p.by_v, blended);
#endif
    return make_surface_vertex(p.position, normal, blend_bilinear(u, v, net.s0, net.s1, net.s2, net.s3),
                               blend_bilinear(u, v, net.t0, net.t1, net.t2, net.t3));
}
#else
FUNCTION TangentFrame SURFACE_FRAME(SURFACE net, DomainPoint point, Vector normal) {
    const SurfacePoint p = SURFACE_POINT(net, point);
#if SURFACE_TANGENTS == 1
    return make_frame(p.by_u, p.by_v, normal);
#else
    const CurveWeights u = curve_weights_linear(point.u);
    const CurveWeights v = curve_weights_linear(point.v);
    const TextureSlope s =
        make_texture_slope(curve_linear(v, texture_step(net.s0, net.s1), texture_step(net.s3, net.s2)),
                           curve_linear(u, texture_step(net.s0, net.s3), texture_step(net.s1, net.s2)));
    const TextureSlope t =
        make_texture_slope(curve_linear(v, texture_step(net.t0, net.t1), texture_step(net.t3, net.t2)),
                           curve_linear(u, texture_step(net.t0, net.t3), texture_step(net.t1, net.t2)));
    return make_texture_frame(p.by_u, p.by_v, s, t, normal);
#endif
}
#endif

KERNELS_END
