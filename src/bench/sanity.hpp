// What makes a figure unbelievable: an output that was not written, or bytes that came faster than memory takes them.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tessera::bench {

/// Fills outputs before a check: as a float a NaN, as an index beyond any buffer.
inline constexpr std::uint32_t sentinel = 0xffffffffu;

std::uint64_t count_unwritten(std::span<const std::uint32_t> words);

inline constexpr std::uint64_t hash_start = 0xcbf29ce484222325ull;
/// Continues a hash over words (FNV-1a, word by word); the same words in other pieces give the same hash.
std::uint64_t hash_words(std::span<const std::uint32_t> words, std::uint64_t hash);

/// A roof of the machine and the size of the memory it was measured over.
struct WriteRoof {
    double bytes_per_second = 0.0;  ///< the best sample of the fastest way to write; 0: unknown
    std::uint64_t bytes = 0;
};

/// Why `bytes` in `seconds` cannot be true, as a sentence; empty where it can. Outputs under a quarter of what the
/// roof was measured over may stay in a cache and are not held against it.
std::string beats_roof(std::uint64_t bytes, double seconds, const WriteRoof& roof);

}  // namespace tessera::bench
