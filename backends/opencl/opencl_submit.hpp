// Puts recorded commands into the queue.
#pragma once

#include "backends/opencl/opencl_pipeline.hpp"

namespace tessera::backends::opencl {

/// Orders a write after everything in the queue. Small data is staged and the call returns at once; large data, or
/// data that finds the staging full, is waited for.
void enqueue_write(const Session& session, Staging& staging, BufferObject& buffer, std::uint64_t offset,
                   std::span<const std::byte> data);

/// Reads after everything in the queue, and waits for it.
void read_now(const Session& session, Staging& staging, BufferObject& buffer, std::uint64_t offset,
              std::span<std::byte> data);

/// Enqueues `commands` and starts them. Returns before they are done, but for indirect dispatches and resolved
/// timestamps, whose values OpenCL gives to the host only: these wait for what comes before them.
void enqueue_commands(const Session& session, Staging& staging, std::span<const gpu::Command> commands);

}  // namespace tessera::backends::opencl
