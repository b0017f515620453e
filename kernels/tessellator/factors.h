// Raw tessellation factors -> a patch record: culling, clamping, rounding and parity of the D3D11 tessellator, by
// integer operations on the bits of the floats, so that denormals, NaN and rounding modes cannot matter.
// Source: D3D11.3 functional specification, 11.7.
#ifndef TESSERA_TESSELLATOR_FACTORS_H
#define TESSERA_TESSELLATOR_FACTORS_H

#include "layout.h"

KERNELS_BEGIN

#define FIXED_ONE 65536u

/// An outer factor lets its patch live if it is > 0: positive denormals and +infinity do, NaN does not.
FUNCTION bool factor_is_positive(uint bits) {
    return (bits - 1u) < 0x7f800000u;
}

/// Clamps a factor to [lowest, highest] (bits of positive floats); NaN and what is not positive give the lowest.
FUNCTION uint clamp_factor_bits(uint bits, uint lowest, uint highest) {
    const uint positive = factor_is_positive(bits) ? bits : 0u;
    const uint low = positive < lowest ? lowest : positive;
    return low > highest ? highest : low;
}

/// A float in [1, 64], given by its bits, in 16.16 fixed point, rounded to nearest even.
FUNCTION uint fixed_from_bits(uint bits) {
    const uint mantissa = (bits & 0x007fffffu) | 0x00800000u;
    const uint shift = 134u - (bits >> 23u);  // 7 for [1, 2), 1 for 64
    const uint whole = mantissa >> shift;
    const uint rest = mantissa & ((1u << shift) - 1u);
    const uint half_unit = 1u << (shift - 1u);
    const bool up = rest > half_unit || (rest == half_unit && (whole & 1u) == 1u);
    return whole + (up ? 1u : 0u);
}

/// A float in [1, 64], given by its bits, rounded up to an integer, in 16.16.
FUNCTION uint fixed_ceiling_from_bits(uint bits) {
    const uint mantissa = (bits & 0x007fffffu) | 0x00800000u;
    const uint shift = 150u - (bits >> 23u);  // bits below the integer part
    return ((mantissa + ((1u << shift) - 1u)) >> shift) << 16u;
}

/// A raw factor in 16.16, clamped and rounded as its partitioning asks. `lowest_odd` is the lower bound that
/// fractional_odd uses: 1 for outer factors, slightly more for some inner ones.
FUNCTION uint resolve_factor(uint bits, uint partitioning, uint lowest_odd) {
    if (partitioning == PARTITIONING_FRACTIONAL_ODD) {
        return fixed_from_bits(clamp_factor_bits(bits, lowest_odd, 0x427c0000u));  // up to 63
    }
    if (partitioning == PARTITIONING_FRACTIONAL_EVEN) {
        return fixed_from_bits(clamp_factor_bits(bits, 0x40000000u, 0x42800000u));  // [2, 64]
    }
    return fixed_ceiling_from_bits(clamp_factor_bits(bits, 0x3f800000u, 0x42800000u));  // [1, 64]
}

/// 1 where a resolved factor makes an odd number of segments. An inner integer factor of 1 counts as even.
FUNCTION uint factor_is_odd(uint factor, uint partitioning, bool inner) {
    if (partitioning == PARTITIONING_FRACTIONAL_ODD) {
        return 1u;
    }
    if (partitioning == PARTITIONING_FRACTIONAL_EVEN) {
        return 0u;
    }
    return inner && factor == FIXED_ONE ? 0u : (factor >> 16u) & 1u;
}

/// How many factors of a domain are outer ones, and how many there are in all.
FUNCTION uint outer_factors(uint domain) {
    return domain == DOMAIN_TRIANGLE ? 3u : (domain == DOMAIN_QUAD ? 4u : 2u);
}
FUNCTION uint total_factors(uint domain) {
    return domain == DOMAIN_TRIANGLE ? 4u : (domain == DOMAIN_QUAD ? 6u : 2u);
}

STRUCT(PatchRecord) {
    uint flags;
    uint factor[6];  // 16.16
};

/// The record of one patch from the bits of its raw factors.
FUNCTION PatchRecord make_patch_record(uint raw[6], uint partitioning, uint domain, uint flip) {
    PatchRecord record;
    record.flags = domain | (flip != 0u ? RECORD_FLIP : 0u);
    const uint outer = outer_factors(domain);
    const uint total = total_factors(domain);
    bool alive = true;
    for (uint i = 0u; i < 6u; ++i) {
        record.factor[i] = 0u;
        alive = alive && (i >= outer || factor_is_positive(raw[i]));
    }
    if (!alive) {
        record.flags = record.flags | RECORD_CULLED;
        return record;
    }
    if (partitioning == PARTITIONING_UNIFORM && domain != DOMAIN_ISOLINE) {
        // One level for the whole patch: the largest factor, so that no edge gets less than it asked for.
        uint level = FIXED_ONE;
        for (uint i = 0u; i < total; ++i) {
            const uint asked = resolve_factor(raw[i], PARTITIONING_INTEGER, 0x3f800000u);
            level = asked > level ? asked : level;
        }
        record.flags = record.flags | RECORD_UNIFORM;
        record.factor[0] = level >> 16u;
        return record;
    }
    // Isolines: the density (factor 0) is an integer in every partitioning.
    const bool density = domain == DOMAIN_ISOLINE;
    bool splits = false;  // fractional_odd: an outer factor (quad: also a raw inner one) exceeds 1 + 2^-17
    for (uint i = 0u; i < total; ++i) {
        const uint clamped = clamp_factor_bits(raw[i], 0x3f800000u, 0x427c0000u);
        splits = splits || (clamped > 0x3f800040u && (i < outer || domain == DOMAIN_QUAD));
    }
    const uint lowest_inner = splits ? 0x3f800080u : 0x3f800000u;  // 1 + 2^-16
    bool single = partitioning != PARTITIONING_FRACTIONAL_EVEN && domain != DOMAIN_ISOLINE;
    for (uint i = 0u; i < total; ++i) {
        const bool inner = i >= outer;
        const uint mode = density && i == 0u ? PARTITIONING_INTEGER : partitioning;
        const uint resolved = resolve_factor(raw[i], mode, inner ? lowest_inner : 0x3f800000u);
        record.factor[i] = resolved;
        record.flags = record.flags | (factor_is_odd(resolved, mode, inner) << (RECORD_ODD_SHIFT + i));
        single = single && resolved == FIXED_ONE;
    }
    record.flags = record.flags | (single ? RECORD_SINGLE : 0u);
    return record;
}

KERNELS_END

#endif
