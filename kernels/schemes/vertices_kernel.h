// Stage 5 for triangles, the kernel of every scheme: control net and domain points -> vertices of 32 bytes. An
// including file names the kernel and its degrees by VERTICES_KERNEL, VERTICES_DEGREE (1..3) and VERTICES_NORMALS (1
// linear, 2 quadratic), and its two helpers by VERTICES_NET and VERTEX_AT. No include guard: every variant includes it
// once.
KERNELS_BEGIN

STRUCT(VERTICES_NET) {
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

FUNCTION SurfaceVertex VERTEX_AT(VERTICES_NET net, DomainPoint point) {
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
#if VERTICES_NORMALS == 1
    const Vector blended = evaluate_linear(b, net.n0, net.n1, net.n2);
#else
    const Vector blended =
        evaluate_quadratic(quadratic_weights(b, 1.0f), net.n0, net.n1, net.n2, net.n01, net.n12, net.n20);
#endif
    return make_surface_vertex(position, blended, blend_linear(b, net.s0, net.s1, net.s2),
                               blend_linear(b, net.t0, net.t1, net.t2));
}

KERNEL6(VERTICES_KERNEL, READ(0, float, nets), READ(1, uint, records), READ(2, uint, offsets),
        READ(3, uint, patch_list), WRITE(4, float, vertex_buffer), UNIFORM(5, EmitParams, params)) {
    const EmitParams p = LOAD_UNIFORM(params);
    const EmissionItem e = make_emission_item(p, ITEM);
    if (e.has_patch == 0u) {
        return;
    }
    const uint patch_index = patch_list[e.entry];
    const TrianglePatch t = LOAD_TRIANGLE_PATCH(records, patch_index);
    const uint start = VERTEX_START(p, offsets, patch_index);
    const uint count = triangle_point_count(t);

    const uint at = patch_index * p.net_stride;
    VERTICES_NET net;
    net.c0 = LOAD_VECTOR(nets, at);
    net.c1 = LOAD_VECTOR(nets, at + 3u);
    net.c2 = LOAD_VECTOR(nets, at + 6u);
#if VERTICES_DEGREE == 2
    net.c01 = LOAD_VECTOR(nets, at + 9u);
    net.c12 = LOAD_VECTOR(nets, at + 12u);
    net.c20 = LOAD_VECTOR(nets, at + 15u);
#elif VERTICES_DEGREE == 3
    net.c01 = LOAD_VECTOR(nets, at + 9u);
    net.c10 = LOAD_VECTOR(nets, at + 12u);
    net.c12 = LOAD_VECTOR(nets, at + 15u);
    net.c21 = LOAD_VECTOR(nets, at + 18u);
    net.c20 = LOAD_VECTOR(nets, at + 21u);
    net.c02 = LOAD_VECTOR(nets, at + 24u);
    net.centre = LOAD_VECTOR(nets, at + 27u);
#endif
    const uint normals = at + 3u * NET_POINTS(VERTICES_DEGREE);
    net.n0 = LOAD_VECTOR(nets, normals);
    net.n1 = LOAD_VECTOR(nets, normals + 3u);
    net.n2 = LOAD_VECTOR(nets, normals + 6u);
#if VERTICES_NORMALS == 2
    net.n01 = LOAD_VECTOR(nets, normals + 9u);
    net.n12 = LOAD_VECTOR(nets, normals + 12u);
    net.n20 = LOAD_VECTOR(nets, normals + 15u);
#endif
    const uint uvs = normals + 3u * NET_POINTS(VERTICES_NORMALS);
    net.s0 = nets[uvs];
    net.t0 = nets[uvs + 1u];
    net.s1 = nets[uvs + 2u];
    net.t1 = nets[uvs + 3u];
    net.s2 = nets[uvs + 4u];
    net.t2 = nets[uvs + 5u];

    if (e.lanes == 1u && triangle_has_rings(t)) {
        // One item has the whole patch: walk its rings side by side, so that the inner loop has no search and no
        // branch.
        for (uint r = 0u; r <= t.rings; ++r) {
            for (uint number = 0u; number < 3u; ++number) {
                const RingSide side = triangle_ring_side(t, r, number);
                const uint first = (start + side.first) * VERTEX_FLOATS;
                for (uint k = 0u; k < side.segments; ++k) {
                    const SurfaceVertex vertex = VERTEX_AT(net, ring_side_point(side, k));
                    STORE_SURFACE_VERTEX(vertex_buffer, first + k * VERTEX_FLOATS, vertex);
                }
            }
        }
        if (t.inside.odd == 0u) {
            const SurfaceVertex vertex = VERTEX_AT(net, triangle_centre());
            STORE_SURFACE_VERTEX(vertex_buffer, (start + count - 1u) * VERTEX_FLOATS, vertex);
        }
        return;
    }
    for (uint i = e.lane; i < count; i = i + e.lanes) {
        const SurfaceVertex vertex = VERTEX_AT(net, triangle_point(t, i));
        STORE_SURFACE_VERTEX(vertex_buffer, (start + i) * VERTEX_FLOATS, vertex);
    }
}

KERNELS_END

#undef VERTICES_KERNEL
#undef VERTICES_DEGREE
#undef VERTICES_NORMALS
#undef VERTICES_NET
#undef VERTEX_AT
