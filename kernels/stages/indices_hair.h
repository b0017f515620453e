// Stage 6 of hair: records and offsets -> two triangles per segment of a ribbon, counter-clockwise from where it faces.
#include "hair/emission.h"
#include "tessellator/isoline.h"

KERNELS_BEGIN

KERNEL4(indices_hair, READ(0, uint, records), READ(1, uint, offsets), WRITE(2, uint, index_buffer),
        UNIFORM(3, RibbonParams, params)) {
    const RibbonParams p = LOAD_UNIFORM(params);
    const RibbonItem e = make_ribbon_item(p, ITEM);
    if (e.has_patch == 0u) {
        return;
    }
    const IsolinePatch t = LOAD_ISOLINE_PATCH(records, e.patch_index);
    const uint base = p.vertex_base + RIBBON_VERTEX_START(p, offsets, e.patch_index);
    const uint start = RIBBON_INDEX_START(p, offsets, e.patch_index);
    const uint count = isoline_segment_count(t);
    for (uint i = e.lane; i < count; i = i + e.lanes) {
        const uint left = base + RIBBON_VERTICES * isoline_segment(t, i);
        const uint at = start + RIBBON_INDICES * i;
        index_buffer[at] = left;
        index_buffer[at + 1u] = left + 1u;
        index_buffer[at + 2u] = left + 2u;
        index_buffer[at + 3u] = left + 1u;
        index_buffer[at + 4u] = left + 3u;
        index_buffer[at + 5u] = left + 2u;
    }
}

KERNELS_END
