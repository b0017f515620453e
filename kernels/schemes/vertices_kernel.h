// Stage 5, the kernel of every scheme and domain: control net and domain points -> vertices of 32 bytes. The build
// makes its variants (kernels/CMakeLists.txt): each names the kernel by VERTICES_KERNEL, gives VERTICES_DEGREE and
// VERTICES_NORMALS (triangle_surface.h), VERTICES_SHARED (1: all patches share a pattern of points; 0: each makes its
// own), and includes the domain and the surface first. No include guard: every variant includes it once.
#include "emission.h"
#include "tessellator/run_points.h"

KERNELS_BEGIN

#if VERTICES_SHARED
KERNEL6(VERTICES_KERNEL, READ(0, float, nets), READ(1, uint, pattern), READ(2, uint, offsets),
        READ(3, uint, patch_list), WRITE(4, float, vertex_buffer), UNIFORM(5, EmitParams, params)) {
#else
KERNEL6(VERTICES_KERNEL, READ(0, float, nets), READ(1, uint, records), READ(2, uint, offsets),
        READ(3, uint, patch_list), WRITE(4, float, vertex_buffer), UNIFORM(5, EmitParams, params)) {
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
#if !VERTICES_SHARED
    const PATCH_TYPE t = LOAD_PATCH(records, patch_index);
#endif
    SURFACE net;
    LOAD_SURFACE(net, nets, patch_index * p.net_stride);
    for (uint next = 0u; next < p.net_stride; next = next + 16u) {
        PREFETCH(nets, (patch_index + 1u) * p.net_stride + next);
    }
    // Runs begin on whole groups of the buffer: the first one may hold a vertex before the patch, which is not written.
    const uint shift = start & (STREAM_GROUP - 1u);
    for (uint at = e.first; at < count + shift; at = at + e.step) {
        const uint first = at - shift;
        uint us[RUN];
        uint vs[RUN];
#if VERTICES_SHARED
        const uint pattern_at = PATTERN_MARGIN + first;
        FOR_RUN(k) {
            us[k] = pattern[RUN_AT(pattern_at, k)];
            vs[k] = pattern[RUN_AT(pattern_at + p.pattern, k)];
        }
#else
        RUN_POINTS(t, at < shift ? 0u : first, first, us, vs)
#endif
        float run[RUN * VERTEX_FLOATS];
        FOR_RUN(k) {
            const SurfaceVertex vertex = SURFACE_VERTEX(net, make_domain_point(us[k], vs[k]));
            PUT_INTO_RUN(run, k, vertex);
        }
        STREAM_VERTICES(vertex_buffer, start, first, count, run);
    }
    STREAM_END;
}

KERNELS_END

#undef VERTICES_KERNEL
#undef VERTICES_SHARED
#include "schemes/end_surface.h"
#include "tessellator/end_domain.h"
