// The stage after vertices and indices, for patches with colours or tangents: those of the corners and domain points ->
// 32 bytes per vertex, blended with the weights of the texture coordinates. The build makes its variants
// (kernels/CMakeLists.txt): each names the kernel by ATTRIBUTES_KERNEL, says by ATTRIBUTES_QUAD whether patches are
// quads, and includes the domain first. No include guard: every variant includes it once.
#include "emission.h"
#include "schemes/surface_attributes.h"
#include "tessellator/run_points.h"

KERNELS_BEGIN

#if RING_TABLE
KERNEL7(ATTRIBUTES_KERNEL, READ(0, float, corner_attributes), READ(1, uint, records), READ(2, uint, offsets),
        READ(3, uint, patch_list), WRITE(4, float, attribute_buffer), READ(5, uint, ring_table),
        UNIFORM(6, EmitParams, params)) {
#else
KERNEL6(ATTRIBUTES_KERNEL, READ(0, float, corner_attributes), READ(1, uint, records), READ(2, uint, offsets),
        READ(3, uint, patch_list), WRITE(4, float, attribute_buffer), UNIFORM(5, EmitParams, params)) {
#endif
    const EmitParams p = LOAD_UNIFORM(params);
    const EmissionItem e = make_emission_item(p, ITEM);
    if (e.has_patch == 0u) {
        STREAM_END;
        return;
    }
    const uint patch_index = patch_list[e.entry];
    const uint start = VERTEX_START(p, offsets, patch_index);
    const uint count = VERTEX_COUNT(offsets, patch_index);
    const PATCH_TYPE t = LOAD_PATCH(records, patch_index);
    const uint corners = PATCH_CORNERS * ATTRIBUTE_FLOATS * patch_index;
    SurfaceAttributes a0;
    LOAD_ATTRIBUTES(a0, corner_attributes, corners);
    SurfaceAttributes a1;
    LOAD_ATTRIBUTES(a1, corner_attributes, corners + ATTRIBUTE_FLOATS);
    SurfaceAttributes a2;
    LOAD_ATTRIBUTES(a2, corner_attributes, corners + 2u * ATTRIBUTE_FLOATS);
#if ATTRIBUTES_QUAD
    SurfaceAttributes a3;
    LOAD_ATTRIBUTES(a3, corner_attributes, corners + 3u * ATTRIBUTE_FLOATS);
#endif
    // As in vertices_kernel.h: a run may begin before the patch and end behind it.
    const uint shift = start & (STREAM_GROUP - 1u);
    for (uint at = e.first; at < count + shift; at = at + e.step) {
        const uint first = at - shift;
        uint us[RUN];
        uint vs[RUN];
        RUN_POINTS(t, ring_table, at < shift ? 0u : first, first, us, vs)
        float run[RUN * ATTRIBUTE_FLOATS];
        FOR_RUN(k) {
#if ATTRIBUTES_QUAD
            const SurfaceAttributes a = blend_quad_attributes(a0, a1, a2, a3, us[k], vs[k]);
#else
            const SurfaceAttributes a = blend_triangle_attributes(a0, a1, a2, us[k], vs[k]);
#endif
            PUT_ATTRIBUTES_INTO_RUN(run, k, a);
        }
        STREAM_VERTICES(attribute_buffer, start, first, count, run);
    }
    STREAM_END;
}

KERNELS_END

#undef ATTRIBUTES_KERNEL
#undef ATTRIBUTES_QUAD
#include "tessellator/end_domain.h"
