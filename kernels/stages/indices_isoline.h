// Stage 6 for isoline patches: records and offsets -> line segments, two indices each.
#include "tessellator/isoline.h"

KERNELS_BEGIN

KERNEL4(indices_isoline, READ(0, uint, records), READ(1, uint, offsets), WRITE(2, uint, index_buffer),
        UNIFORM(3, EmitParams, params)) {
    const EmitParams p = LOAD_UNIFORM(params);
    const uint item = ITEM;
    if ((item >> p.lanes_log2) >= p.patch_count) {
        return;
    }
    const uint patch_index = p.first_patch + (item >> p.lanes_log2);
    const uint lanes = 1u << p.lanes_log2;
    const IsolinePatch t = LOAD_ISOLINE_PATCH(records, patch_index);
    const uint base = p.vertex_base + (offsets[patch_index * COUNT_WORDS] - p.first_vertex);
    const uint start = offsets[patch_index * COUNT_WORDS + 1u] - p.first_index;
    const uint count = isoline_segment_count(t);
    for (uint i = item & (lanes - 1u); i < count; i = i + lanes) {
        const uint first = base + isoline_segment(t, i);
        index_buffer[start + 2u * i] = first;
        index_buffer[start + 2u * i + 1u] = first + 1u;
    }
}

KERNELS_END
