// The reference backend's own objects: plain memory, a function pointer, pointers per slot, and clock readings.
#pragma once

#include "base/host_memory.hpp"
#include "gpu/types.hpp"

#include <array>
#include <optional>
#include <vector>

namespace tessera::backends::reference {

/// Starts on a page: kernels' loops run fastest on memory that starts on a cache line, and streaming asks for one.
struct Buffer : gpu::BackendObject {
    explicit Buffer(std::size_t size) : pages(size), memory(pages.data()) {}

    HostMemory pages;
    std::byte* memory;
};

struct Pipeline : gpu::BackendObject {
    explicit Pipeline(const gpu::Kernel& kernel) : kernel(kernel) {}

    const gpu::Kernel& kernel;  // outlives its pipeline
};

/// All slots that the limits allow: WebGPU's eight storage buffers and one uniform.
using Slots = std::array<std::byte*, 9>;

struct BindGroup : gpu::BackendObject {
    Slots slots{};
    std::optional<std::uint32_t> uniform_slot;
};

struct QuerySet : gpu::BackendObject {
    explicit QuerySet(std::uint32_t count) : nanoseconds(count) {}

    std::vector<std::uint64_t> nanoseconds;
};

}  // namespace tessera::backends::reference
