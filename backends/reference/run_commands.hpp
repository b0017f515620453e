// Runs recorded commands on the calling thread and its helpers.
#pragma once

#include "gpu/types.hpp"

namespace tessera::backends::reference {

/// Runs `commands` in order; all is done on return. `limits` bounds the group counts of indirect dispatches.
void run_commands(std::span<const gpu::Command> commands, const gpu::Limits& limits);

/// Sets `size` bytes at `memory` (aligned to 4) to a repeated 32-bit value, with all threads where it pays.
void fill_memory(std::byte* memory, std::uint64_t size, std::uint32_t value);

}  // namespace tessera::backends::reference
