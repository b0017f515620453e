// Stage 3: records -> vertices and indices per patch.
#include "tessellator/triangle.h"

KERNELS_BEGIN

KERNEL3(counts, READ(0, uint, records), WRITE(1, uint, patch_counts), UNIFORM(2, CountsParams, params)) {
    const CountsParams p = LOAD_UNIFORM(params);
    const uint patch_index = ITEM;
    if (patch_index >= p.patch_count) {
        return;
    }
    const TrianglePatch t = LOAD_TRIANGLE_PATCH(records, patch_index);
    patch_counts[patch_index * COUNT_WORDS] = triangle_point_count(t);
    patch_counts[patch_index * COUNT_WORDS + 1u] = 3u * triangle_triangle_count(t);
}

KERNELS_END
