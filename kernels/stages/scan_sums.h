// Stage 4, upwards: the sum of each block of SCAN_BLOCK pairs. Repeated on its own output until one block is left.
#include "layout.h"

KERNELS_BEGIN

KERNEL3(scan_sums, READ(0, uint, values), WRITE(1, uint, sums), UNIFORM(2, ScanParams, params)) {
    const ScanParams p = LOAD_UNIFORM(params);
    const uint block = ITEM;
    const uint first = block * SCAN_BLOCK;
    if (first >= p.count) {
        return;
    }
    const uint last = p.count - first < SCAN_BLOCK ? p.count : first + SCAN_BLOCK;
    uint vertices = 0u;
    uint indices = 0u;
    for (uint i = first; i < last; ++i) {
        vertices = vertices + values[i * COUNT_WORDS];
        indices = indices + values[i * COUNT_WORDS + 1u];
    }
    sums[block * COUNT_WORDS] = vertices;
    sums[block * COUNT_WORDS + 1u] = indices;
}

KERNELS_END
