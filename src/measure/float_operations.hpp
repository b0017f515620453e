// What a kernel computes, counted in its SPIR-V.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace tessera::measure {

/// Operations on single floats, as the source writes them: before a driver folds or fuses any. Comparisons,
/// conversions, changes of sign and integers do not count.
struct FloatOperations {
    std::uint64_t additions = 0;  ///< and subtractions
    std::uint64_t multiplications = 0;
    std::uint64_t roots = 0;      ///< calls of kernels/exact.h's reciprocal square root
    std::uint64_t divisions = 0;  ///< calls of its reciprocal
    std::uint64_t in_those = 0;   ///< additions and multiplications inside those calls, counted above too

    /// Everything.
    std::uint64_t total() const { return additions + multiplications; }
    /// As papers count: a reciprocal square root and a reciprocal are one operation each.
    std::uint64_t with_roots_as_one() const { return total() - in_those + roots + divisions; }
};

FloatOperations operator+(const FloatOperations& a, const FloatOperations& b);
/// `b` must be a part of `a`.
FloatOperations operator-(const FloatOperations& a, const FloatOperations& b);

/// Counts what one call of `function` does, with all it calls: the body of a loop once, and all branches. "main" of an
/// emitting kernel is then the work for one vertex, that of a control-net kernel the work for one patch. `function` is
/// the name without parameters. Throws Error(usage) for words that are no SPIR-V module and for a function that it has
/// not.
FloatOperations count_float_operations(std::span<const std::uint32_t> spirv, std::string_view function = "main");

}  // namespace tessera::measure
