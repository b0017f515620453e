#include "bench/sanity.hpp"

#include <fmt/format.h>
#include <algorithm>

namespace tessera::bench {

std::uint64_t count_unwritten(std::span<const std::uint32_t> words) {
    return static_cast<std::uint64_t>(std::ranges::count(words, sentinel));
}

std::uint64_t hash_words(std::span<const std::uint32_t> words, std::uint64_t hash) {
    for (const std::uint32_t word : words) {
        hash = (hash ^ word) * 0x100000001b3ull;
    }
    return hash;
}

std::string beats_roof(std::uint64_t bytes, double seconds, const WriteRoof& roof) {
    if (roof.bytes_per_second <= 0.0 || bytes < roof.bytes / 4) {
        return {};
    }
    const double rate = seconds > 0.0 ? static_cast<double>(bytes) / seconds : 1e300;
    if (rate <= roof.bytes_per_second) {
        return {};
    }
    return fmt::format("It would write {:.1f} GB/s, more than the {:.1f} GB/s that memory took at best.", rate * 1e-9,
                       roof.bytes_per_second * 1e-9);
}

}  // namespace tessera::bench
