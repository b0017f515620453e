// Domain points by themselves, the kernel of every domain: all u, then from word p.pattern on all v. An including file
// names the kernel by POINTS_KERNEL and its domain by PATCH_TYPE, LOAD_PATCH and POINT_AT.
// No include guard: every variant includes it once.
KERNELS_BEGIN

KERNEL5(POINTS_KERNEL, READ(0, uint, records), READ(1, uint, offsets), READ(2, uint, patch_list),
        WRITE(3, uint, points), UNIFORM(4, EmitParams, params)) {
    const EmitParams p = LOAD_UNIFORM(params);
    const EmissionItem e = make_emission_item(p, ITEM);
    if (e.has_patch == 0u) {
        return;
    }
    const uint patch_index = patch_list[e.entry];
    const PATCH_TYPE t = LOAD_PATCH(records, patch_index);
    const uint start = VERTEX_START(p, offsets, patch_index);
    const uint count = VERTEX_COUNT(offsets, patch_index);
    for (uint first = e.first; first < count; first = first + e.step) {
        const uint end = first + run_length(first, count);
        for (uint i = first; i < end; ++i) {
            const DomainPoint point = POINT_AT(t, i);
            points[start + i] = point.u;
            points[p.pattern + start + i] = point.v;
        }
    }
}

KERNELS_END

#undef POINTS_KERNEL
#undef POINT_AT
#include "tessellator/end_domain.h"
