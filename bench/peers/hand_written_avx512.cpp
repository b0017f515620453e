// Compiled for AVX-512; called only where the CPU has it.
#include <immintrin.h>

#include "bench/peers/hand_written_loops.hpp"

namespace tessera::peers {
namespace {

struct Avx512 {
    using V = __m512;
    static constexpr int width = 16;

    static V load(const float* at) { return _mm512_load_ps(at); }
    static V set(float x) { return _mm512_set1_ps(x); }
    static V mul(V a, V b) { return _mm512_mul_ps(a, b); }
    static V fma(V a, V b, V c) { return _mm512_fmadd_ps(a, b, c); }
    static V rsqrt(V x) {
        const V y = _mm512_rsqrt14_ps(x);
        const V half = _mm512_mul_ps(_mm512_mul_ps(x, y), _mm512_set1_ps(-0.5f));
        return _mm512_mul_ps(y, _mm512_fmadd_ps(half, y, _mm512_set1_ps(1.5f)));
    }

    // Slot 4 lane + j holds point 4 j + lane, so that vertices come out in order.
    static int point_of_slot(int slot) { return 4 * (slot & 3) + (slot >> 2); }

    static void transpose(const V* r, V* out) {
        const V a0 = _mm512_unpacklo_ps(r[0], r[1]), a1 = _mm512_unpacklo_ps(r[2], r[3]);
        const V a2 = _mm512_unpackhi_ps(r[0], r[1]), a3 = _mm512_unpackhi_ps(r[2], r[3]);
        const V b0 = _mm512_unpacklo_ps(r[4], r[5]), b1 = _mm512_unpacklo_ps(r[6], r[7]);
        const V b2 = _mm512_unpackhi_ps(r[4], r[5]), b3 = _mm512_unpackhi_ps(r[6], r[7]);
        const V front[4] = {_mm512_shuffle_ps(a0, a1, 0x44), _mm512_shuffle_ps(a0, a1, 0xee),
                            _mm512_shuffle_ps(a2, a3, 0x44), _mm512_shuffle_ps(a2, a3, 0xee)};
        const V back[4] = {_mm512_shuffle_ps(b0, b1, 0x44), _mm512_shuffle_ps(b0, b1, 0xee),
                           _mm512_shuffle_ps(b2, b3, 0x44), _mm512_shuffle_ps(b2, b3, 0xee)};
        const __m512i low = _mm512_set_epi64(11, 10, 3, 2, 9, 8, 1, 0);
        const __m512i high = _mm512_set_epi64(15, 14, 7, 6, 13, 12, 5, 4);
        for (int j = 0; j < 4; ++j) {
            const __m512d f = _mm512_castps_pd(front[j]), b = _mm512_castps_pd(back[j]);
            out[2 * j] = _mm512_castpd_ps(_mm512_permutex2var_pd(f, low, b));
            out[2 * j + 1] = _mm512_castpd_ps(_mm512_permutex2var_pd(f, high, b));
        }
    }

    static void stream_vertices(const V* rows, float* out) {
        V vertices[8];
        transpose(rows, vertices);
        for (int i = 0; i < 8; ++i) {
            _mm512_stream_ps(out + 16 * i, vertices[i]);
        }
    }

    static void stream_some(const V* rows, float* out, int from, int to) {
        alignas(64) V vertices[8];
        transpose(rows, vertices);
        const auto* at = reinterpret_cast<const float*>(vertices);
        for (int i = from; i < to; ++i) {
            _mm256_stream_ps(out + 8 * i, _mm256_load_ps(at + 8 * i));
        }
    }

    static void stream_indices(const std::uint32_t* pattern, std::uint32_t count, std::uint32_t base,
                               std::uint32_t* out) {
        const __m512i add = _mm512_set1_epi32(static_cast<int>(base));
        std::uint32_t i = 0;
        if ((reinterpret_cast<std::uintptr_t>(out) & 63u) == 0) {
            for (; i + 16 <= count; i += 16) {
                _mm512_stream_si512(reinterpret_cast<__m512i*>(out + i),
                                    _mm512_add_epi32(_mm512_loadu_si512(pattern + i), add));
            }
        }
        for (; i < count; ++i) {
            out[i] = pattern[i] + base;
        }
    }

    static void fence() { _mm_sfence(); }
};

}  // namespace

Loops avx512_loops() {
    return {"AVX-512", Avx512::width, Avx512::point_of_slot, emit<Avx512>};
}

}  // namespace tessera::peers
