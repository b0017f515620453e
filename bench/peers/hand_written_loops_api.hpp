// What the hand-written evaluator hands to its inner loops.
#pragma once

#include <cstdint>

namespace tessera::peers {

/// Floats of a net: ten points and six normals of three, three texture coordinates of two.
inline constexpr std::uint32_t net_floats = 54;
/// Weights of a point: ten cubic, six quadratic, three linear.
inline constexpr std::uint32_t weight_rows = 19;

/// Every patch has the same pattern.
struct Emission {
    const float* nets;        ///< net_floats per patch
    const float* weights[2];  ///< per group of points `weight_rows` rows of a vector; [1] has one idle slot in front
    std::uint32_t points;     ///< of a patch
    const std::uint32_t* pattern_indices;
    std::uint32_t index_count;  ///< of a patch
    float* vertices;            ///< eight floats each, aligned to 64 bytes
    std::uint32_t* indices;     ///< aligned to 64 bytes
};

/// Inner loops for one instruction set.
struct Loops {
    const char* name;
    int width;  ///< points per vector
    /// The point that stands in slot `slot` of a group of `width`.
    int (*point_of_slot)(int slot);
    void (*emit)(const Emission& emission, std::uint32_t first_patch, std::uint32_t last_patch);
};

Loops avx512_loops();
Loops avx2_loops();

}  // namespace tessera::peers
