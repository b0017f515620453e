// Stage 3: records -> vertices and indices per patch.
#include "tessellator/isoline.h"
#include "tessellator/quad.h"
#include "tessellator/triangle.h"

KERNELS_BEGIN

KERNEL3(counts, READ(0, uint, records), WRITE(1, uint, patch_counts), UNIFORM(2, CountsParams, params)) {
    const CountsParams p = LOAD_UNIFORM(params);
    const uint patch_index = ITEM;
    if (patch_index >= p.patch_count) {
        return;
    }
    const uint domain = records[patch_index * RECORD_WORDS] & RECORD_DOMAIN_MASK;
    uint vertices = 0u;
    uint indices = 0u;
    if (domain == DOMAIN_TRIANGLE) {
        const TrianglePatch t = LOAD_TRIANGLE_PATCH(records, patch_index);
        vertices = triangle_point_count(t);
        indices = 3u * triangle_triangle_count(t);
    } else if (domain == DOMAIN_QUAD) {
        const QuadPatch q = LOAD_QUAD_PATCH(records, patch_index);
        vertices = quad_point_count(q);
        indices = 3u * quad_triangle_count(q);
    } else {
        const IsolinePatch l = LOAD_ISOLINE_PATCH(records, patch_index);
        vertices = isoline_point_count(l);
        indices = 2u * isoline_segment_count(l);
    }
    patch_counts[patch_index * COUNT_WORDS] = vertices;
    patch_counts[patch_index * COUNT_WORDS + 1u] = indices;
}

KERNELS_END
