// Stage 6, the kernel of every domain that makes triangles. An including file names the kernel by INDICES_KERNEL and
// its domain by PATCH_TYPE, LOAD_PATCH, TRIANGLE_COUNT and TRIANGLE_AT. No include guard: every variant includes it
// once.
KERNELS_BEGIN

KERNEL5(INDICES_KERNEL, READ(0, uint, records), READ(1, uint, offsets), READ(2, uint, patch_list),
        WRITE(3, uint, index_buffer), UNIFORM(4, EmitParams, params)) {
    const EmitParams p = LOAD_UNIFORM(params);
    const EmissionItem e = make_emission_item(p, ITEM);
    if (e.has_patch == 0u) {
        return;
    }
    const uint patch_index = patch_list[e.entry];
    const PATCH_TYPE t = LOAD_PATCH(records, patch_index);
    const bool flip = (t.flags & RECORD_FLIP) != 0u;
    const uint base = p.vertex_base + VERTEX_START(p, offsets, patch_index);
    const uint start = INDEX_START(p, offsets, patch_index);
    const uint count = TRIANGLE_COUNT(t);
    for (uint i = e.lane; i < count; i = i + e.lanes) {
        const Triangle corners = TRIANGLE_AT(t, i);
        const uint at = start + 3u * i;
        index_buffer[at] = base + corners.a;
        index_buffer[at + 1u] = base + (flip ? corners.c : corners.b);
        index_buffer[at + 2u] = base + (flip ? corners.b : corners.c);
    }
}

KERNELS_END

#undef INDICES_KERNEL
#undef PATCH_TYPE
#undef LOAD_PATCH
#undef TRIANGLE_COUNT
#undef TRIANGLE_AT
