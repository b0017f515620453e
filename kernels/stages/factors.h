// Stage 1: raw factors -> a record per patch.
#include "tessellator/factors.h"

KERNELS_BEGIN

KERNEL4(factors, READ(0, float, raw_factors), READ(1, uint, patch_indices), WRITE(2, uint, records),
        UNIFORM(3, FactorsParams, params)) {
    const FactorsParams p = LOAD_UNIFORM(params);
    const uint patch_index = ITEM;
    if (patch_index >= p.patch_count) {
        return;
    }
    uint raw[6];
    for (uint i = 0u; i < 6u; ++i) {
        raw[i] = float_bits(raw_factors[patch_index * p.per_patch * PATCH_FACTORS + i]);
    }
    uint domain = p.domain;
    if (domain == DOMAIN_PER_PATCH) {
        const uint last_corner = patch_indices[PATCH_CORNERS * patch_index + 3u];
        domain = last_corner == NO_CORNER ? DOMAIN_TRIANGLE : DOMAIN_QUAD;
    }
    const PatchRecord record = make_patch_record(raw, p.partitioning, domain, p.flip);
    records[patch_index * RECORD_WORDS] = record.flags;
    for (uint i = 0u; i < 6u; ++i) {
        records[patch_index * RECORD_WORDS + 1u + i] = record.factor[i];
    }
    records[patch_index * RECORD_WORDS + 7u] = 0u;
}

KERNELS_END
