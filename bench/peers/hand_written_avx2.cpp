// Compiled for AVX2 and FMA; called only where the CPU has them.
#include <immintrin.h>

#include "bench/peers/hand_written_loops.hpp"

namespace tessera::peers {
namespace {

struct Avx2 {
    using V = __m256;
    static constexpr int width = 8;

    static V load(const float* at) { return _mm256_load_ps(at); }
    static V set(float x) { return _mm256_set1_ps(x); }
    static V mul(V a, V b) { return _mm256_mul_ps(a, b); }
    static V fma(V a, V b, V c) { return _mm256_fmadd_ps(a, b, c); }
    static V rsqrt(V x) {
        const V y = _mm256_rsqrt_ps(x);
        const V half = _mm256_mul_ps(_mm256_mul_ps(x, y), _mm256_set1_ps(-0.5f));
        return _mm256_mul_ps(y, _mm256_fmadd_ps(half, y, _mm256_set1_ps(1.5f)));
    }

    // Slot 4 lane + j holds point 2 j + lane, so that vertices come out in order.
    static int point_of_slot(int slot) { return 2 * (slot & 3) + (slot >> 2); }

    static void transpose(const V* r, V* out) {
        const V a0 = _mm256_unpacklo_ps(r[0], r[1]), a1 = _mm256_unpacklo_ps(r[2], r[3]);
        const V a2 = _mm256_unpackhi_ps(r[0], r[1]), a3 = _mm256_unpackhi_ps(r[2], r[3]);
        const V b0 = _mm256_unpacklo_ps(r[4], r[5]), b1 = _mm256_unpacklo_ps(r[6], r[7]);
        const V b2 = _mm256_unpackhi_ps(r[4], r[5]), b3 = _mm256_unpackhi_ps(r[6], r[7]);
        const V front[4] = {_mm256_shuffle_ps(a0, a1, 0x44), _mm256_shuffle_ps(a0, a1, 0xee),
                            _mm256_shuffle_ps(a2, a3, 0x44), _mm256_shuffle_ps(a2, a3, 0xee)};
        const V back[4] = {_mm256_shuffle_ps(b0, b1, 0x44), _mm256_shuffle_ps(b0, b1, 0xee),
                           _mm256_shuffle_ps(b2, b3, 0x44), _mm256_shuffle_ps(b2, b3, 0xee)};
        for (int j = 0; j < 4; ++j) {
            out[2 * j] = _mm256_permute2f128_ps(front[j], back[j], 0x20);
            out[2 * j + 1] = _mm256_permute2f128_ps(front[j], back[j], 0x31);
        }
    }

    static void stream_vertices(const V* rows, float* out) {
        V vertices[8];
        transpose(rows, vertices);
        for (int i = 0; i < 8; ++i) {
            _mm256_stream_ps(out + 8 * i, vertices[i]);
        }
    }

    static void stream_some(const V* rows, float* out, int from, int to) {
        V vertices[8];
        transpose(rows, vertices);
        for (int i = from; i < to; ++i) {
            _mm256_stream_ps(out + 8 * i, vertices[i]);
        }
    }

    static void stream_indices(const std::uint32_t* pattern, std::uint32_t count, std::uint32_t base,
                               std::uint32_t* out) {
        const __m256i add = _mm256_set1_epi32(static_cast<int>(base));
        std::uint32_t i = 0;
        if ((reinterpret_cast<std::uintptr_t>(out) & 31u) == 0) {
            for (; i + 8 <= count; i += 8) {
                const __m256i corners = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(pattern + i));
                _mm256_stream_si256(reinterpret_cast<__m256i*>(out + i), _mm256_add_epi32(corners, add));
            }
        }
        for (; i < count; ++i) {
            out[i] = pattern[i] + base;
        }
    }

    static void fence() { _mm_sfence(); }
};

}  // namespace

Loops avx2_loops() {
    return {"AVX2", Avx2::width, Avx2::point_of_slot, emit<Avx2>};
}

}  // namespace tessera::peers
