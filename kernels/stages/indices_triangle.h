// Stage 6 for triangle patches: records and offsets -> triangles, three indices each.
#include "emission.h"
#include "tessellator/triangle.h"

KERNELS_BEGIN

KERNEL5(indices_triangle, READ(0, uint, records), READ(1, uint, offsets), READ(2, uint, patch_list),
        WRITE(3, uint, index_buffer), UNIFORM(4, EmitParams, params)) {
    const EmitParams p = LOAD_UNIFORM(params);
    const EmissionItem e = make_emission_item(p, ITEM);
    if (e.has_patch == 0u) {
        return;
    }
    const uint patch_index = patch_list[e.entry];
    const TrianglePatch t = LOAD_TRIANGLE_PATCH(records, patch_index);
    const bool flip = (t.flags & RECORD_FLIP) != 0u;
    const uint base = p.vertex_base + VERTEX_START(p, offsets, patch_index);
    const uint start = INDEX_START(p, offsets, patch_index);
    const uint count = triangle_triangle_count(t);
    if (e.lanes == 1u && triangle_has_rings(t)) {
        // One item has the whole patch: row by row and side by side, so that the inner loop has no search.
        const uint outer = triangle_outer_count(t);
        for (uint i = 0u; i < outer; ++i) {
            const Triangle corners = triangle_outer_triangle(t, i);
            STORE_TRIANGLE(index_buffer, start + 3u * i, base, flip, corners);
        }
        const uint last = triangle_last_row(t);
        for (uint j = 2u; j <= last; ++j) {
            for (uint number = 0u; number < 3u; ++number) {
                const RowSide side = triangle_row_side(t, j, number);
                for (uint s = 0u; s < side.triangles; ++s) {
                    const Triangle corners = row_side_triangle(side, s);
                    STORE_TRIANGLE(index_buffer, start + 3u * (side.first + s), base, flip, corners);
                }
            }
        }
        if (t.inside.odd != 0u) {
            const Triangle corners = triangle_odd_centre(t);
            STORE_TRIANGLE(index_buffer, start + 3u * (count - 1u), base, flip, corners);
        }
        return;
    }
    for (uint i = e.lane; i < count; i = i + e.lanes) {
        const Triangle corners = triangle_triangle(t, i);
        STORE_TRIANGLE(index_buffer, start + 3u * i, base, flip, corners);
    }
}

KERNELS_END
