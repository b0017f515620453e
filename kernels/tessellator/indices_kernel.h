// Stage 6, the kernel of every domain with triangles: records and offsets -> triangles, three indices each. An
// including file names the kernel by INDICES_KERNEL and includes triangle_domain.h or quad_domain.h first. No include
// guard: every variant includes it once.
KERNELS_BEGIN

KERNEL5(INDICES_KERNEL, READ(0, uint, records), READ(1, uint, offsets), READ(2, uint, patch_list),
        WRITE(3, uint, index_buffer), UNIFORM(4, EmitParams, params)) {
    const EmitParams p = LOAD_UNIFORM(params);
    const EmissionItem e = make_emission_item(p, ITEM);
    if (e.has_patch == 0u) {
        return;
    }
    const uint patch_index = patch_list[e.entry];
    const uint base = p.vertex_base + VERTEX_START(p, offsets, patch_index);
    const uint start = INDEX_START(p, offsets, patch_index);
    const uint words = INDEX_COUNT(offsets, patch_index);
    const PATCH_TYPE t = LOAD_PATCH(records, patch_index);
    const bool flip = (t.flags & RECORD_FLIP) != 0u;
    const bool rings = PATCH_HAS_RINGS(t);
    const uint count = words / 3u;
    const uint outer = rings ? OUTER_COUNT(t) : count;
    for (uint part = 0u; part < 2u; ++part) {
        const uint end = part == 0u ? outer : count;
        for (uint first = (part == 0u ? 0u : outer) + e.first; first < end; first = first + e.step) {
            uint run[RUN * 3u];
            if (part != 0u) {
                FOR_RUN(k) {
                    const Triangle corners = INNER_TRIANGLE(t, first + k);
                    STORE_TRIANGLE(run, 3u * k, base, flip, corners);
                }
            } else if (rings) {
                FOR_RUN(k) {
                    const Triangle corners = OUTER_TRIANGLE(t, first + k);
                    STORE_TRIANGLE(run, 3u * k, base, flip, corners);
                }
            } else {
                FOR_RUN(k) {
                    const Triangle corners = PLAIN_TRIANGLE(t, first + k);
                    STORE_TRIANGLE(run, 3u * k, base, flip, corners);
                }
            }
            const uint made = 3u * run_length(first, end);
            for (uint word = 0u; word < made; ++word) {
                index_buffer[start + 3u * first + word] = run[word];
            }
        }
    }
}

KERNELS_END

#undef INDICES_KERNEL
#include "tessellator/end_domain.h"
