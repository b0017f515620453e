// How the work items of the hair kernels share out the patches of a batch: see kernels/emission.h.
#ifndef TESSERA_HAIR_EMISSION_H
#define TESSERA_HAIR_EMISSION_H

#include "layout.h"

KERNELS_BEGIN

STRUCT(RibbonItem) {
    uint has_patch;  // 0: the item is beyond the last patch
    uint patch_index;
    uint lane;   // the first element this item makes
    uint lanes;  // the step to its next one
};

FUNCTION RibbonItem make_ribbon_item(RibbonParams p, uint item) {
    RibbonItem e;
    e.lanes = 1u << p.lanes_log2;
    e.lane = item & (e.lanes - 1u);
    e.patch_index = p.first + (item >> p.lanes_log2);
    e.has_patch = (item >> p.lanes_log2) < p.count ? 1u : 0u;
    return e;
}

/// Where a patch's ribbons begin in the buffers of a batch. Offsets count isoline points, and two indices per segment.
#define RIBBON_VERTEX_START(p, offsets, patch_index) \
    (RIBBON_VERTICES * offsets[(patch_index)*COUNT_WORDS] - (p).first_vertex)
#define RIBBON_INDEX_START(p, offsets, patch_index) \
    (RIBBON_INDICES / 2u * offsets[(patch_index)*COUNT_WORDS + 1u] - (p).first_index)

KERNELS_END

#endif
