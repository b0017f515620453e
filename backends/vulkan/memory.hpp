// Device memory: which type serves which use, one allocation per object.
#pragma once

#include <optional>
#include <string_view>

#include "backends/vulkan/context.hpp"

namespace tessera::backends::vulkan {

/// Who touches the memory, and how.
enum class MemoryUse {
    device,    ///< the device only; mapped as well where device memory is cached by the host (software, shared memory)
    unmapped,  ///< the device only, never mapped
    upload,    ///< the host writes in sequence, the device reads
    readback,  ///< the device writes, the host reads
};

struct Allocation {
    vk::raii::DeviceMemory memory{nullptr};
    std::uint64_t size = 0;       ///< bytes
    std::byte* mapped = nullptr;  ///< null where the host cannot touch it
    bool coherent = true;         ///< false: flush after host writes, invalidate before host reads
};

struct BufferAllocation {
    Allocation allocation;  // before the buffer, so that the buffer goes first
    vk::raii::Buffer buffer{nullptr};
};

struct ImageAllocation {
    Allocation allocation;
    vk::raii::Image image{nullptr};
};

/// The type of memory that serves `use` best among those whose bit is set in `allowed`; nothing where none serves.
std::optional<std::uint32_t> choose_memory_type(const vk::PhysicalDeviceMemoryProperties& memory, std::uint32_t allowed,
                                                MemoryUse use);

/// Allocates for `requirements`, mapped where `use` wants it. `label` is named in the error.
/// Throws Error(device_unavailable) when memory is out.
Allocation allocate(const Context& context, const vk::MemoryRequirements& requirements, MemoryUse use,
                    std::string_view label);

/// A buffer of `size` bytes (> 0) bound to memory of its own. Throws Error(device_unavailable).
BufferAllocation create_buffer(const Context& context, std::uint64_t size, vk::BufferUsageFlags usage, MemoryUse use,
                               std::string_view label);

/// An image bound to memory of its own (MemoryUse::unmapped). Throws Error(device_unavailable).
ImageAllocation create_image(const Context& context, const vk::ImageCreateInfo& info, std::string_view label);

/// Makes host writes to mapped memory known to the device; nothing to do where it is coherent.
void flush(const Context& context, const Allocation& allocation, std::uint64_t offset, std::uint64_t size);

/// Makes device writes, already made visible to the host by a barrier and a fence, readable through `mapped`.
void invalidate(const Context& context, const Allocation& allocation, std::uint64_t offset, std::uint64_t size);

}  // namespace tessera::backends::vulkan
