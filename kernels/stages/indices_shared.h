// Stage 6 where all patches of a domain share a pattern: offsets and the pattern's indices -> indices.
#include "emission.h"

KERNELS_BEGIN

KERNEL5(indices_shared, READ(0, uint, pattern), READ(1, uint, offsets), READ(2, uint, patch_list),
        WRITE(3, uint, index_buffer), UNIFORM(4, EmitParams, params)) {
    const EmitParams p = LOAD_UNIFORM(params);
    const EmissionItem e = make_emission_item(p, ITEM);
    if (e.has_patch == 0u) {
        STREAM_END;
        return;
    }
    const uint patch_index = patch_list[e.entry];
    const uint base = p.vertex_base + VERTEX_START(p, offsets, patch_index);
    const uint start = INDEX_START(p, offsets, patch_index);
    const uint words = INDEX_COUNT(offsets, patch_index);
    // Whole runs that begin on a multiple of RUN words are streamed; the first lane adds what is left at both ends.
    const uint unaligned = (0u - start) & (RUN - 1u);
    const uint lead = unaligned < words ? unaligned : words;
    for (uint at = lead + e.first; at + RUN <= words; at = at + e.step) {
        uint run[RUN];
        FOR_RUN(k) {
            run[k] = base + pattern[RUN_AT(at, k)];
        }
        STREAM_WORDS(index_buffer, start + at, run);
    }
    const uint tail = e.first == 0u ? words - ((words - lead) & (RUN - 1u)) : words;
    for (uint at = e.first == 0u ? 0u : lead; at < lead; ++at) {
        index_buffer[start + at] = base + pattern[at];
    }
    for (uint at = tail; at < words; ++at) {
        index_buffer[start + at] = base + pattern[at];
    }
    STREAM_END;
}

KERNELS_END
