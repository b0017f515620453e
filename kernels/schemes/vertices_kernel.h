// Stage 5 for triangles, the kernel of every scheme: control net and domain points -> vertices of 32 bytes. An
// including file names the kernel and its degrees by VERTICES_KERNEL, VERTICES_DEGREE (1..3) and VERTICES_NORMALS (1
// linear, 2 quadratic). No include guard: every variant includes it once.
KERNELS_BEGIN

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

    const uint net = patch_index * p.net_stride;
    const Vector c0 = LOAD_VECTOR(nets, net);
    const Vector c1 = LOAD_VECTOR(nets, net + 3u);
    const Vector c2 = LOAD_VECTOR(nets, net + 6u);
#if VERTICES_DEGREE == 2
    const Vector c01 = LOAD_VECTOR(nets, net + 9u);
    const Vector c12 = LOAD_VECTOR(nets, net + 12u);
    const Vector c20 = LOAD_VECTOR(nets, net + 15u);
#elif VERTICES_DEGREE == 3
    const Vector c01 = LOAD_VECTOR(nets, net + 9u);
    const Vector c10 = LOAD_VECTOR(nets, net + 12u);
    const Vector c12 = LOAD_VECTOR(nets, net + 15u);
    const Vector c21 = LOAD_VECTOR(nets, net + 18u);
    const Vector c20 = LOAD_VECTOR(nets, net + 21u);
    const Vector c02 = LOAD_VECTOR(nets, net + 24u);
    const Vector centre = LOAD_VECTOR(nets, net + 27u);
#endif
    const uint normals = net + 3u * NET_POINTS(VERTICES_DEGREE);
    const Vector n0 = LOAD_VECTOR(nets, normals);
    const Vector n1 = LOAD_VECTOR(nets, normals + 3u);
    const Vector n2 = LOAD_VECTOR(nets, normals + 6u);
#if VERTICES_NORMALS == 2
    const Vector n01 = LOAD_VECTOR(nets, normals + 9u);
    const Vector n12 = LOAD_VECTOR(nets, normals + 12u);
    const Vector n20 = LOAD_VECTOR(nets, normals + 15u);
#endif
    const uint uvs = normals + 3u * NET_POINTS(VERTICES_NORMALS);
    const float s0 = nets[uvs];
    const float t0 = nets[uvs + 1u];
    const float s1 = nets[uvs + 2u];
    const float t1 = nets[uvs + 3u];
    const float s2 = nets[uvs + 4u];
    const float t2 = nets[uvs + 5u];

    for (uint i = e.lane; i < count; i = i + e.lanes) {
        const DomainPoint point = triangle_point(t, i);
        const Barycentric b = make_barycentric(point.u, point.v);
#if VERTICES_DEGREE == 1
        const Vector position = evaluate_linear(b, c0, c1, c2);
#elif VERTICES_DEGREE == 2
        const Vector position = evaluate_quadratic(quadratic_weights(b, 2.0f), c0, c1, c2, c01, c12, c20);
#else
        const Vector position = evaluate_cubic(cubic_weights(b), c0, c1, c2, c01, c10, c12, c21, c20, c02, centre);
#endif
#if VERTICES_NORMALS == 1
        const Vector blended = evaluate_linear(b, n0, n1, n2);
#else
        const Vector blended = evaluate_quadratic(quadratic_weights(b, 1.0f), n0, n1, n2, n01, n12, n20);
#endif
        // Opposite normals may cancel; the fallback is the same from every patch.
        const Vector normal = normalise(blended, make_vector(0.0f, 0.0f, 1.0f));
        const uint at = (start + i) * VERTEX_FLOATS;
        vertex_buffer[at] = flush_tiny(position.x);
        vertex_buffer[at + 1u] = flush_tiny(position.y);
        vertex_buffer[at + 2u] = flush_tiny(position.z);
        vertex_buffer[at + 3u] = normal.x;
        vertex_buffer[at + 4u] = normal.y;
        vertex_buffer[at + 5u] = normal.z;
        vertex_buffer[at + 6u] = flush_tiny(blend_linear(b, s0, s1, s2));
        vertex_buffer[at + 7u] = flush_tiny(blend_linear(b, t0, t1, t2));
    }
}

KERNELS_END

#undef VERTICES_KERNEL
#undef VERTICES_DEGREE
#undef VERTICES_NORMALS
