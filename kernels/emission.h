// How the work items of an emitting kernel share out the patches of a list: 2^lanes_log2 items, the lanes, take turns
// on a patch.
#ifndef TESSERA_EMISSION_H
#define TESSERA_EMISSION_H

#include "layout.h"

KERNELS_BEGIN

STRUCT(EmissionItem) {
    uint has_patch;  // 0: the item is beyond the last patch
    uint entry;      // of the patch list
    uint lane;       // the first element this item makes
    uint lanes;      // the step to its next one
};

FUNCTION EmissionItem make_emission_item(EmitParams p, uint item) {
    EmissionItem e;
    e.lanes = 1u << p.lanes_log2;
    e.lane = item & (e.lanes - 1u);
    e.entry = p.first + (item >> p.lanes_log2);
    e.has_patch = (item >> p.lanes_log2) < p.count ? 1u : 0u;
    return e;
}

/// Where a patch's vertices and indices begin in the buffers of a batch.
#define VERTEX_START(p, offsets, patch_index) (offsets[(patch_index)*COUNT_WORDS] - (p).first_vertex)
#define INDEX_START(p, offsets, patch_index) (offsets[(patch_index)*COUNT_WORDS + 1u] - (p).first_index)

/// Writes the point indices of a triangle; `flip` turns its winding round.
#define STORE_TRIANGLE(buffer, at, base, flip, corners)                \
    buffer[at] = (base) + (corners).a;                                 \
    buffer[(at) + 1u] = (base) + ((flip) ? (corners).c : (corners).b); \
    buffer[(at) + 2u] = (base) + ((flip) ? (corners).b : (corners).c)

KERNELS_END

#endif
