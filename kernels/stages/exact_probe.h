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
    results[6u * i] = exact_reciprocal(arguments[i]);
    results[6u * i + 1u] = exact_rsqrt(arguments[i]);
    results[6u * i + 2u] = exact_divide(numerators[i], arguments[i]);
    results[6u * i + 3u] = exact_exp2(arguments[i]);
    results[6u * i + 4u] = exact_log2(arguments[i]);
    results[6u * i + 5u] = exact_power(bits_float(0x3f7fffffu - (i << 4u)), to_float(i & 1023u) + 0.5f);
}

KERNELS_END
