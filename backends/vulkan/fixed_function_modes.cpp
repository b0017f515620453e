#include "backends/vulkan/fixed_function_modes.hpp"

#include <cassert>

namespace tessera::backends::vulkan {
namespace {

// SPIR-V specification, 2.3 (layout of a module), 3.6 (execution modes) and 3.49.6 (OpExecutionMode).
constexpr std::size_t header_words = 5;
constexpr std::uint32_t op_execution_mode = 16;
enum ExecutionMode : std::uint32_t {
    spacing_equal = 1,
    spacing_fractional_even = 2,
    spacing_fractional_odd = 3,
    vertex_order_cw = 4,
    vertex_order_ccw = 5,
};

ExecutionMode spacing_of(Partitioning partitioning) {
    assert(partitioning != Partitioning::pow2 && partitioning != Partitioning::uniform);
    if (partitioning == Partitioning::fractional_odd) return spacing_fractional_odd;
    return partitioning == Partitioning::fractional_even ? spacing_fractional_even : spacing_equal;
}

}  // namespace

std::vector<std::uint32_t> with_modes(std::span<const std::uint32_t> spirv, Partitioning partitioning, bool clockwise) {
    std::vector<std::uint32_t> words(spirv.begin(), spirv.end());
    int changed = 0;
    for (std::size_t at = header_words; at < words.size(); at += words[at] >> 16) {
        if ((words[at] & 0xffffu) != op_execution_mode) continue;
        std::uint32_t& mode = words[at + 2];
        if (mode >= spacing_equal && mode <= spacing_fractional_odd) {
            mode = spacing_of(partitioning);
            ++changed;
        } else if (mode == vertex_order_cw || mode == vertex_order_ccw) {
            mode = clockwise ? vertex_order_cw : vertex_order_ccw;
            ++changed;
        }
    }
    assert(changed == 2);
    static_cast<void>(changed);
    return words;
}

}  // namespace tessera::backends::vulkan
