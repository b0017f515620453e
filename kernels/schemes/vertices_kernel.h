// Stage 5, the kernel of every scheme and domain: control net and domain points -> vertices of 32 bytes. The build
// makes its variants (kernels/CMakeLists.txt): each names the kernel by VERTICES_KERNEL, gives VERTICES_DEGREE and
// VERTICES_NORMALS (triangle_surface.h), VERTICES_SHARED (1: all patches share a pattern, whose triangles are written
// too; 0: each makes its own points), and includes the domain and the surface first. No include guard: every variant
// includes it once.
#include "emission.h"
#include "tessellator/run_points.h"

KERNELS_BEGIN

#if VERTICES_SHARED
KERNEL8(VERTICES_KERNEL, READ(0, float, nets), READ(1, uint, pattern), READ(2, uint, offsets),
        READ(3, uint, patch_list), WRITE(4, float, vertex_buffer), READ(5, uint, pattern_indices),
        WRITE(6, uint, index_buffer), UNIFORM(7, EmitParams, params)) {
#elif RING_TABLE
KERNEL7(VERTICES_KERNEL, READ(0, float, nets), READ(1, uint, records), READ(2, uint, offsets),
        READ(3, uint, patch_list), WRITE(4, float, vertex_buffer), READ(5, uint, ring_table),
        UNIFORM(6, EmitParams, params)) {
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
#if VERTICES_SHARED
    // Stage 6, in the same pass: vertices are bound by instructions and indices by memory, so that one hides the other
    // where they take turns. Whole runs that begin on a multiple of RUN words are streamed; the first lane adds what is
    // left at both ends.
    const uint base = p.vertex_base + start;
    const uint index_start = INDEX_START(p, offsets, patch_index);
    const uint words = INDEX_COUNT(offsets, patch_index);
    const WholeRuns whole = whole_runs(index_start, 0u, words);
    // Words up to which runs are streamed, more after each run of vertices; where a run is one element, all at the end.
    const uint turn = RUN > 1u ? e.step * (words / (count + 1u) + 1u) : 0u;
    uint until = whole.begin;
    uint word = whole.begin + e.first;
#endif
    // Runs begin on whole groups of the buffer: the first one may hold a vertex before the patch, which is not written.
    const uint shift = start & (STREAM_GROUP - 1u);
    for (uint at = e.first; at < count + shift; at = at + e.step) {
        const uint first = at - shift;
        float run[RUN * VERTEX_FLOATS];
#if VERTICES_SHARED && PATTERN_HAS_WEIGHTS && defined(SURFACE_HAS_WEIGHTS)
        const uint weights_at =
            PATTERN_WEIGHTS_AT(p.pattern) + (shift * PATTERN_RUNS(count) * PATTERN_RUN + at) * PATTERN_WEIGHTS;
        if (RUN == PATTERN_RUN) {
            FOR_RUN(k) {
                PatternWeights w;
                LOAD_PATTERN_WEIGHTS(w, pattern, weights_at, k);
                const SurfaceVertex vertex = SURFACE_WEIGHTED(net, w);
                PUT_INTO_RUN(run, k, vertex);
            }
        } else
#endif
        {
            uint us[RUN];
            uint vs[RUN];
#if VERTICES_SHARED
            const uint pattern_at = PATTERN_MARGIN + first;
            FOR_RUN(k) {
                us[k] = pattern[RUN_AT(pattern_at, k)];
                vs[k] = pattern[RUN_AT(pattern_at + p.pattern, k)];
            }
#else
            RUN_POINTS(t, ring_table, at < shift ? 0u : first, first, us, vs)
#endif
            FOR_RUN(k) {
                const SurfaceVertex vertex = SURFACE_VERTEX(net, make_domain_point(us[k], vs[k]));
                PUT_INTO_RUN(run, k, vertex);
            }
        }
        STREAM_VERTICES(vertex_buffer, start, first, count, run);
#if VERTICES_SHARED
        until = until + turn < whole.end ? until + turn : whole.end;
        COPY_INDEX_RUNS(index_buffer, index_start, word, until, e.step, base, pattern_indices, 0u)
#endif
    }
#if VERTICES_SHARED
    COPY_INDEX_RUNS(index_buffer, index_start, word, whole.end, e.step, base, pattern_indices, 0u)
    if (e.first == 0u) {
        COPY_INDICES(index_buffer, index_start, 0u, whole.begin, base, pattern_indices, 0u)
        COPY_INDICES(index_buffer, index_start, whole.end, words, base, pattern_indices, 0u)
    }
#endif
    STREAM_END;
}

KERNELS_END

#undef VERTICES_KERNEL
#undef VERTICES_SHARED
#include "schemes/end_surface.h"
#include "tessellator/end_domain.h"
