#include "bench/streaming_stores.hpp"

#include <algorithm>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace tessera::bench {
namespace {

void fill_words(std::byte* memory, std::size_t size, std::uint32_t word) {
    auto* words = reinterpret_cast<std::uint32_t*>(memory);
    std::fill(words, words + size / 4, word);
}

#if defined(__x86_64__)

__attribute__((target("avx512f"))) void stream_avx512(std::byte* memory, std::size_t size, std::uint32_t word) {
    const __m512i value = _mm512_set1_epi32(static_cast<int>(word));
    for (std::size_t at = 0; at < size; at += 64) {
        _mm512_stream_si512(reinterpret_cast<__m512i*>(memory + at), value);
    }
    _mm_sfence();
}

__attribute__((target("avx512f"))) void plain_avx512(std::byte* memory, std::size_t size, std::uint32_t word) {
    const __m512i value = _mm512_set1_epi32(static_cast<int>(word));
    for (std::size_t at = 0; at < size; at += 64) {
        _mm512_store_si512(memory + at, value);
    }
}

__attribute__((target("avx"))) void stream_avx(std::byte* memory, std::size_t size, std::uint32_t word) {
    const __m256i value = _mm256_set1_epi32(static_cast<int>(word));
    for (std::size_t at = 0; at < size; at += 32) {
        _mm256_stream_si256(reinterpret_cast<__m256i*>(memory + at), value);
    }
    _mm_sfence();
}

void stream_sse2(std::byte* memory, std::size_t size, std::uint32_t word) {
    const __m128i value = _mm_set1_epi32(static_cast<int>(word));
    for (std::size_t at = 0; at < size; at += 16) {
        _mm_stream_si128(reinterpret_cast<__m128i*>(memory + at), value);
    }
    _mm_sfence();
}

#endif

struct Stores {
    const char* name;
    void (*stream)(std::byte*, std::size_t, std::uint32_t);
    void (*plain)(std::byte*, std::size_t, std::uint32_t);
};

Stores choose() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) return {"AVX-512", stream_avx512, plain_avx512};
    if (__builtin_cpu_supports("avx")) return {"AVX", stream_avx, fill_words};
    return {"SSE2", stream_sse2, fill_words};
#else
    return {"none", fill_words, fill_words};
#endif
}

const Stores& stores() {
    static const Stores chosen = choose();
    return chosen;
}

}  // namespace

const char* streaming_store_name() {
    return stores().name;
}

void stream_fill(std::byte* memory, std::size_t size, std::uint32_t word) {
    stores().stream(memory, size, word);
}

void plain_fill(std::byte* memory, std::size_t size, std::uint32_t word) {
    stores().plain(memory, size, word);
}

}  // namespace tessera::bench
