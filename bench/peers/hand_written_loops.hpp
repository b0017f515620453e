// The inner loops of the hand-written evaluator, for vectors of any width: every file that includes it is compiled for
// one instruction set and gives a `Simd` with width, operations and stores. Nothing of the standard library is
// included, so that no inline function of it is compiled for an instruction set that the machine may lack.
#pragma once

#include "bench/peers/hand_written_loops_api.hpp"

namespace tessera::peers {

/// position x y z, normal x y z, uv, of `width` points.
template <typename Simd>
struct Points {
    typename Simd::V row[8];
};

template <typename Simd>
[[gnu::always_inline]] inline Points<Simd> evaluate(const float* net, const float* weights) {
    using V = typename Simd::V;
    constexpr int w = Simd::width;
    Points<Simd> p;
    for (int axis = 0; axis < 3; ++axis) {
        V sum = Simd::mul(Simd::load(weights), Simd::set(net[axis]));
        for (int k = 1; k < 10; ++k) {
            sum = Simd::fma(Simd::load(weights + k * w), Simd::set(net[3 * k + axis]), sum);
        }
        p.row[axis] = sum;
    }
    for (int axis = 0; axis < 3; ++axis) {
        V sum = Simd::mul(Simd::load(weights + 10 * w), Simd::set(net[30 + axis]));
        for (int k = 1; k < 6; ++k) {
            sum = Simd::fma(Simd::load(weights + (10 + k) * w), Simd::set(net[30 + 3 * k + axis]), sum);
        }
        p.row[3 + axis] = sum;
    }
    const V length2 = Simd::fma(p.row[3], p.row[3], Simd::fma(p.row[4], p.row[4], Simd::mul(p.row[5], p.row[5])));
    const V scale = Simd::rsqrt(length2);
    for (int axis = 3; axis < 6; ++axis) {
        p.row[axis] = Simd::mul(p.row[axis], scale);
    }
    for (int axis = 0; axis < 2; ++axis) {
        V sum = Simd::mul(Simd::load(weights + 16 * w), Simd::set(net[48 + axis]));
        for (int k = 1; k < 3; ++k) {
            sum = Simd::fma(Simd::load(weights + (16 + k) * w), Simd::set(net[48 + 2 * k + axis]), sum);
        }
        p.row[6 + axis] = sum;
    }
    return p;
}

template <typename Simd>
void emit(const Emission& e, std::uint32_t first_patch, std::uint32_t last_patch) {
    constexpr int w = Simd::width;
    for (std::uint32_t patch = first_patch; patch < last_patch; ++patch) {
        const float* net = e.nets + std::uint64_t{patch} * net_floats;
        const std::uint64_t first_vertex = std::uint64_t{patch} * e.points;
        // A vertex is half a cache line: where the patch begins in the middle of one, its first vertex goes alone.
        const int lead = static_cast<int>(first_vertex & 1u);
        const float* weights = e.weights[lead];
        for (int at = -lead; at < static_cast<int>(e.points); at += w, weights += weight_rows * w) {
            const Points<Simd> p = evaluate<Simd>(net, weights);
            float* out = e.vertices + (static_cast<std::int64_t>(first_vertex) + at) * 8;
            if (at >= 0 && at + w <= static_cast<int>(e.points)) {
                Simd::stream_vertices(p.row, out);
            } else {
                const int from = at < 0 ? -at : 0;
                const int to = static_cast<int>(e.points) - at < w ? static_cast<int>(e.points) - at : w;
                Simd::stream_some(p.row, out, from, to);
            }
        }
        Simd::stream_indices(e.pattern_indices, e.index_count, static_cast<std::uint32_t>(first_vertex),
                             e.indices + std::uint64_t{patch} * e.index_count);
    }
    Simd::fence();
}

}  // namespace tessera::peers
