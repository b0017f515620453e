// Stage 4, downwards: the exclusive prefix sums of one level from those of the level above; the total comes last, as
// pair number `count`.
#include "layout.h"

KERNELS_BEGIN

KERNEL4(scan_offsets, READ(0, uint, values), READ(1, uint, block_offsets), WRITE(2, uint, offsets),
        UNIFORM(3, ScanParams, params)) {
    const ScanParams p = LOAD_UNIFORM(params);
    const uint block = ITEM;
    const uint first = block * SCAN_BLOCK;
    if (first >= p.count) {
        return;
    }
    const uint last = p.count - first < SCAN_BLOCK ? p.count : first + SCAN_BLOCK;
    uint vertices = block_offsets[block * COUNT_WORDS];
    uint indices = block_offsets[block * COUNT_WORDS + 1u];
    for (uint i = first; i < last; ++i) {
        offsets[i * COUNT_WORDS] = vertices;
        offsets[i * COUNT_WORDS + 1u] = indices;
        vertices = vertices + values[i * COUNT_WORDS];
        indices = indices + values[i * COUNT_WORDS + 1u];
    }
    if (last == p.count) {
        offsets[last * COUNT_WORDS] = vertices;
        offsets[last * COUNT_WORDS + 1u] = indices;
    }
}

KERNELS_END
