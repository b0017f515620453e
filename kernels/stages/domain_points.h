// The domain points themselves, u and v in 16.16 per vertex: what `tessera pattern` shows and checks.
#include "tessellator/triangle.h"

KERNELS_BEGIN

KERNEL4(domain_points, READ(0, uint, records), READ(1, uint, offsets), WRITE(2, uint, points),
        UNIFORM(3, EmitParams, params)) {
    const EmitParams p = LOAD_UNIFORM(params);
    const uint item = ITEM;
    if ((item >> p.lanes_log2) >= p.patch_count) {
        return;
    }
    const uint patch_index = p.first_patch + (item >> p.lanes_log2);
    const uint lanes = 1u << p.lanes_log2;
    const TrianglePatch t = LOAD_TRIANGLE_PATCH(records, patch_index);
    const uint start = offsets[patch_index * COUNT_WORDS] - p.first_vertex;
    const uint count = triangle_point_count(t);
    for (uint i = item & (lanes - 1u); i < count; i = i + lanes) {
        const DomainPoint point = triangle_point(t, i);
        points[2u * (start + i)] = point.u;
        points[2u * (start + i) + 1u] = point.v;
    }
}

KERNELS_END
