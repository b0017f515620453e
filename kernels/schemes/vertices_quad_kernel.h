// Stage 5 for quads, the kernel of every scheme: control net and domain points -> vertices of 32 bytes. An including
// file names the kernel and its degrees by VERTICES_KERNEL, VERTICES_DEGREE (1..3) and VERTICES_NORMALS (1 linear, 2
// quadratic). No include guard: every variant includes it once.
KERNELS_BEGIN

KERNEL6(VERTICES_KERNEL, READ(0, float, nets), READ(1, uint, records), READ(2, uint, offsets),
        READ(3, uint, patch_list), WRITE(4, float, vertex_buffer), UNIFORM(5, EmitParams, params)) {
    const EmitParams p = LOAD_UNIFORM(params);
    const EmissionItem e = make_emission_item(p, ITEM);
    if (e.has_patch == 0u) {
        return;
    }
    const uint patch_index = patch_list[e.entry];
    const QuadPatch q = LOAD_QUAD_PATCH(records, patch_index);
    const uint start = VERTEX_START(p, offsets, patch_index);
    const uint count = quad_point_count(q);

    const uint net = patch_index * p.net_stride;
    const Vector c0 = LOAD_VECTOR(nets, net);
    const Vector c1 = LOAD_VECTOR(nets, net + 3u);
    const Vector c2 = LOAD_VECTOR(nets, net + 6u);
    const Vector c3 = LOAD_VECTOR(nets, net + 9u);
#if VERTICES_DEGREE == 2
    const Vector c01 = LOAD_VECTOR(nets, net + 12u);
    const Vector c12 = LOAD_VECTOR(nets, net + 15u);
    const Vector c23 = LOAD_VECTOR(nets, net + 18u);
    const Vector c30 = LOAD_VECTOR(nets, net + 21u);
    const Vector centre = LOAD_VECTOR(nets, net + 24u);
#elif VERTICES_DEGREE == 3
    const Vector c01 = LOAD_VECTOR(nets, net + 12u);
    const Vector c10 = LOAD_VECTOR(nets, net + 15u);
    const Vector c12 = LOAD_VECTOR(nets, net + 18u);
    const Vector c21 = LOAD_VECTOR(nets, net + 21u);
    const Vector c23 = LOAD_VECTOR(nets, net + 24u);
    const Vector c32 = LOAD_VECTOR(nets, net + 27u);
    const Vector c30 = LOAD_VECTOR(nets, net + 30u);
    const Vector c03 = LOAD_VECTOR(nets, net + 33u);
    const Vector inner0 = LOAD_VECTOR(nets, net + 36u);
    const Vector inner1 = LOAD_VECTOR(nets, net + 39u);
    const Vector inner2 = LOAD_VECTOR(nets, net + 42u);
    const Vector inner3 = LOAD_VECTOR(nets, net + 45u);
#endif
    const uint normals = net + 3u * QUAD_NET_POINTS(VERTICES_DEGREE);
    const Vector n0 = LOAD_VECTOR(nets, normals);
    const Vector n1 = LOAD_VECTOR(nets, normals + 3u);
    const Vector n2 = LOAD_VECTOR(nets, normals + 6u);
    const Vector n3 = LOAD_VECTOR(nets, normals + 9u);
#if VERTICES_NORMALS == 2
    const Vector n01 = LOAD_VECTOR(nets, normals + 12u);
    const Vector n12 = LOAD_VECTOR(nets, normals + 15u);
    const Vector n23 = LOAD_VECTOR(nets, normals + 18u);
    const Vector n30 = LOAD_VECTOR(nets, normals + 21u);
    const Vector middle = LOAD_VECTOR(nets, normals + 24u);
#endif
    const uint uvs = normals + 3u * QUAD_NET_POINTS(VERTICES_NORMALS);

    for (uint i = e.lane; i < count; i = i + e.lanes) {
        const DomainPoint point = quad_point(q, i);
        const CurveWeights u = curve_weights_linear(point.u);
        const CurveWeights v = curve_weights_linear(point.v);
#if VERTICES_DEGREE == 1
        const Vector position = evaluate_bilinear(u, v, c0, c1, c2, c3);
#elif VERTICES_DEGREE == 2
        const Vector position =
            evaluate_biquadratic(curve_weights_quadratic(point.u, 2.0f), curve_weights_quadratic(point.v, 2.0f), c0, c1,
                                 c2, c3, c01, c12, c23, c30, centre);
#else
        const CurveWeights cubic_v = curve_weights_cubic(point.v);
        const Vector position =
            column_cubic(curve_weights_cubic(point.u), column_cubic(cubic_v, c0, c03, c30, c3),
                         column_cubic(cubic_v, c01, inner0, inner3, c32),
                         column_cubic(cubic_v, c10, inner1, inner2, c23), column_cubic(cubic_v, c1, c12, c21, c2));
#endif
#if VERTICES_NORMALS == 1
        const Vector blended = evaluate_bilinear(u, v, n0, n1, n2, n3);
#else
        const Vector blended =
            evaluate_biquadratic(curve_weights_quadratic(point.u, 1.0f), curve_weights_quadratic(point.v, 1.0f), n0, n1,
                                 n2, n3, n01, n12, n23, n30, middle);
#endif
        const SurfaceVertex vertex = make_surface_vertex(
            position, blended, blend_bilinear(u, v, nets[uvs], nets[uvs + 2u], nets[uvs + 4u], nets[uvs + 6u]),
            blend_bilinear(u, v, nets[uvs + 1u], nets[uvs + 3u], nets[uvs + 5u], nets[uvs + 7u]));
        STORE_SURFACE_VERTEX(vertex_buffer, (start + i) * VERTEX_FLOATS, vertex);
    }
}

KERNELS_END

#undef VERTICES_KERNEL
#undef VERTICES_DEGREE
#undef VERTICES_NORMALS
