// Stores of the host that go round the caches.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tessera::bench {

/// The widest non-temporal store that this CPU has: "AVX-512", "AVX", "SSE2", or "none" where plain stores stand in.
const char* streaming_store_name();

/// Fills `size` bytes (a multiple of 64, `memory` aligned to 64) with a repeated word by non-temporal stores, and
/// orders them before later stores.
void stream_fill(std::byte* memory, std::size_t size, std::uint32_t word);

/// Same with plain stores of the same width, which the compiler may not turn into something else.
void plain_fill(std::byte* memory, std::size_t size, std::uint32_t word);

}  // namespace tessera::bench
