// The stage after vertices and indices, where tangents are asked for: control net, domain points and the normals of the
// vertices -> a tangent frame of 32 bytes per vertex. The build makes its variants (kernels/CMakeLists.txt): each names
// the kernel by TANGENTS_KERNEL, gives VERTICES_DEGREE, VERTICES_NORMALS (0) and SURFACE_TANGENTS (triangle_surface.h),
// and includes the domain and the surface first. No include guard: every variant includes it once.
#include "emission.h"
#include "tessellator/run_points.h"

KERNELS_BEGIN

#if RING_TABLE
KERNEL8(TANGENTS_KERNEL, READ(0, float, nets), READ(1, uint, records), READ(2, uint, offsets),
        READ(3, uint, patch_list), READ(4, float, vertex_buffer), WRITE(5, float, tangent_buffer),
        READ(6, uint, ring_table), UNIFORM(7, EmitParams, params)) {
#else
KERNEL7(TANGENTS_KERNEL, READ(0, float, nets), READ(1, uint, records), READ(2, uint, offsets),
        READ(3, uint, patch_list), READ(4, float, vertex_buffer), WRITE(5, float, tangent_buffer),
        UNIFORM(6, EmitParams, params)) {
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
    if (count == 0u) {
        STREAM_END;
        return;  // there is no vertex to read
    }
    const PATCH_TYPE t = LOAD_PATCH(records, patch_index);
    SURFACE net;
    LOAD_POINTS(net, nets, patch_index * p.net_stride);
#if SURFACE_TANGENTS == 2
    LOAD_UVS(net, nets, patch_index * p.net_stride + p.uvs);
#endif
    // As in vertices_kernel.h: a run may begin before the patch and end behind it.
    const uint shift = start & (STREAM_GROUP - 1u);
    for (uint at = e.first; at < count + shift; at = at + e.step) {
        const uint first = at - shift;
        uint us[RUN];
        uint vs[RUN];
        RUN_POINTS(t, ring_table, at < shift ? 0u : first, first, us, vs)
        float xs[RUN];
        float ys[RUN];
        float zs[RUN];
        FOR_RUN(k) {
            const uint vertex = start + (first + k < count ? first + k : 0u);
            xs[k] = vertex_buffer[VERTEX_FLOATS * vertex + 3u];
            ys[k] = vertex_buffer[VERTEX_FLOATS * vertex + 4u];
            zs[k] = vertex_buffer[VERTEX_FLOATS * vertex + 5u];
        }
        float run[RUN * VERTEX_FLOATS];
        FOR_RUN(k) {
            const TangentFrame frame =
                SURFACE_FRAME(net, make_domain_point(us[k], vs[k]), make_vector(xs[k], ys[k], zs[k]));
            PUT_FRAME_INTO_RUN(run, k, frame);
        }
        STREAM_VERTICES(tangent_buffer, start, first, count, run);
    }
    STREAM_END;
}

KERNELS_END

#undef TANGENTS_KERNEL
#include "schemes/end_surface.h"
#include "tessellator/end_domain.h"
