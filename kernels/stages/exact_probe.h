// A probe, not a stage: the functions of exact.h over any inputs, so that tests compare devices and measure errors.
#include "exact.h"
#include "layout.h"

KERNELS_BEGIN

KERNEL4(exact_probe, READ(0, float, numerators), READ(1, float, arguments), WRITE(2, float, results),
        UNIFORM(3, CountsParams, params)) {
    const CountsParams p = LOAD_UNIFORM(params);
    const uint i = ITEM;
    if (i >= p.patch_count) {
        return;
    }
    results[3u * i] = exact_reciprocal(arguments[i]);
    results[3u * i + 1u] = exact_rsqrt(arguments[i]);
    results[3u * i + 2u] = exact_divide(numerators[i], arguments[i]);
}

KERNELS_END
