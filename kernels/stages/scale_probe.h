// A probe, not a stage: output[i] = input[i] * factor + 1, rounded twice. Tells whether a device contracts, and serves
// the tests of the device room.
#include "layout.h"

KERNELS_BEGIN

KERNEL3(scale_probe, READ(0, float, source), WRITE(1, float, result), UNIFORM(2, ScaleProbeParams, params)) {
    const ScaleProbeParams p = LOAD_UNIFORM(params);
    const uint i = ITEM;
    if (i >= p.count) {
        return;
    }
    result[i] = source[i] * p.factor + 1.0f;
}

KERNELS_END
