// The reference backend's own objects: plain memory, a function pointer, pointers per slot, and clock readings.
#pragma once

#include "gpu/types.hpp"

#include <array>
#include <new>

namespace tessera::backends::reference {

/// A cache line and the widest vector register; kernels' loops run fastest on memory that starts on one.
inline constexpr std::align_val_t memory_alignment{64};

/// Exactly `size` bytes, so that the address sanitizer sees a kernel that leaves its buffer by one byte.
struct Buffer : gpu::BackendObject {
    explicit Buffer(std::byte* memory) : memory(memory) {}
    ~Buffer() override { ::operator delete(memory, memory_alignment); }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

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
