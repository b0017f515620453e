// Stage 6 for isoline patches: records and offsets -> line segments, two indices each.
#include "emission.h"
#include "tessellator/isoline.h"

KERNELS_BEGIN

KERNEL5(indices_isoline, READ(0, uint, records), READ(1, uint, offsets), READ(2, uint, patch_list),
        WRITE(3, uint, index_buffer), UNIFORM(4, EmitParams, params)) {
    const EmitParams p = LOAD_UNIFORM(params);
    const EmissionItem e = make_emission_item(p, ITEM);
    if (e.has_patch == 0u) {
        return;
    }
    const uint patch_index = patch_list[e.entry];
    const IsolinePatch t = LOAD_ISOLINE_PATCH(records, patch_index);
    const uint base = p.vertex_base + VERTEX_START(p, offsets, patch_index);
    const uint start = INDEX_START(p, offsets, patch_index);
    const uint count = isoline_segment_count(t);
    for (uint first = e.first; first < count; first = first + e.step) {
        const uint end = first + run_length(first, count);
        for (uint i = first; i < end; ++i) {
            const uint point = base + isoline_segment(t, i);
            index_buffer[start + 2u * i] = point;
            index_buffer[start + 2u * i + 1u] = point + 1u;
        }
    }
}

KERNELS_END
