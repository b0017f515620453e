// Stage 6 for quad patches: records and offsets -> triangles, three indices each.
#include "emission.h"
#include "tessellator/quad.h"

KERNELS_BEGIN

KERNEL5(indices_quad, READ(0, uint, records), READ(1, uint, offsets), READ(2, uint, patch_list),
        WRITE(3, uint, index_buffer), UNIFORM(4, EmitParams, params)) {
    const EmitParams p = LOAD_UNIFORM(params);
    const EmissionItem e = make_emission_item(p, ITEM);
    if (e.has_patch == 0u) {
        return;
    }
    const uint patch_index = patch_list[e.entry];
    const QuadPatch t = LOAD_QUAD_PATCH(records, patch_index);
    const bool flip = (t.flags & RECORD_FLIP) != 0u;
    const uint base = p.vertex_base + VERTEX_START(p, offsets, patch_index);
    const uint start = INDEX_START(p, offsets, patch_index);
    const uint count = quad_triangle_count(t);
    for (uint i = e.lane; i < count; i = i + e.lanes) {
        const Triangle corners = quad_triangle(t, i);
        STORE_TRIANGLE(index_buffer, start + 3u * i, base, flip, corners);
    }
}

KERNELS_END
