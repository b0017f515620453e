#include "backends/vulkan/memory.hpp"

#include <vector>

#include "backends/vulkan/errors.hpp"

namespace tessera::backends::vulkan {
namespace {

using Property = vk::MemoryPropertyFlagBits;

/// What a use asks for, and what it would rather leave to others.
struct Preference {
    vk::MemoryPropertyFlags wanted, avoided;
};

/// Best first; no type of memory that serves the use is missed by the last.
std::vector<Preference> preferences(MemoryUse use) {
    const auto host = Property::eHostVisible | Property::eHostCoherent;
    switch (use) {
        case MemoryUse::device:
            // Host-cached device memory means that host and device share it: mapped, no staging is needed.
            return {{Property::eDeviceLocal | Property::eHostVisible | Property::eHostCached, {}},
                    {Property::eDeviceLocal, Property::eHostVisible},
                    {Property::eDeviceLocal, {}},
                    {{}, {}}};
        case MemoryUse::unmapped:
            return {{Property::eDeviceLocal, Property::eHostVisible}, {Property::eDeviceLocal, {}}, {{}, {}}};
        case MemoryUse::upload:
            return {{host, Property::eDeviceLocal | Property::eHostCached}, {host, {}}, {Property::eHostVisible, {}}};
        case MemoryUse::readback:
            return {{host | Property::eHostCached, {}},
                    {Property::eHostVisible | Property::eHostCached, {}},
                    {Property::eHostVisible, {}}};
    }
    return {};
}

/// Ranges of non-coherent memory start and end at multiples of nonCoherentAtomSize, or at the end.
vk::MappedMemoryRange atoms(const Context& context, const Allocation& allocation, std::uint64_t offset,
                            std::uint64_t size) {
    const std::uint64_t atom = context.properties.limits.nonCoherentAtomSize;
    const std::uint64_t first = offset / atom * atom;
    const std::uint64_t last = (offset + size + atom - 1) / atom * atom;
    return {*allocation.memory, first, last < allocation.size ? last - first : VK_WHOLE_SIZE};
}

}  // namespace

std::optional<std::uint32_t> choose_memory_type(const vk::PhysicalDeviceMemoryProperties& memory, std::uint32_t allowed,
                                                MemoryUse use) {
    // Never chosen: memory that is protected, that backs only tiles, or that needs features we do not ask for.
    const vk::MemoryPropertyFlags never =
        Property::eProtected | Property::eLazilyAllocated | Property::eDeviceCoherentAMD | Property::eDeviceUncachedAMD;
    for (const Preference& preference : preferences(use)) {
        for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
            const vk::MemoryPropertyFlags flags = memory.memoryTypes[i].propertyFlags;
            if ((allowed & (1u << i)) != 0 && (flags & preference.wanted) == preference.wanted &&
                !(flags & (preference.avoided | never))) {
                return i;
            }
        }
    }
    return std::nullopt;
}

Allocation allocate(const Context& context, const vk::MemoryRequirements& requirements, MemoryUse use,
                    std::string_view label) {
    const auto type = choose_memory_type(context.memory, requirements.memoryTypeBits, use);
    if (!type) {
        throw Error(ErrorKind::device_unavailable,
                    fmt::format("The Vulkan device '{}' has no type of memory that fits '{}'; choose another device.",
                                context.properties.deviceName.data(), label));
    }
    const std::uint64_t heap = context.memory.memoryHeaps[context.memory.memoryTypes[*type].heapIndex].size;
    if (requirements.size > heap) {
        throw Error(ErrorKind::device_unavailable,
                    fmt::format("'{}' needs {} bytes, and the Vulkan device '{}' has {} in all; lower the factor or "
                                "--memory-budget, or choose another device.",
                                label, requirements.size, context.properties.deviceName.data(), heap));
    }
    return guarded(fmt::format("allocating {} bytes for '{}'", requirements.size, label), [&] {
        Allocation result;
        result.memory = vk::raii::DeviceMemory(context.device, vk::MemoryAllocateInfo(requirements.size, *type));
        result.size = requirements.size;
        const vk::MemoryPropertyFlags flags = context.memory.memoryTypes[*type].propertyFlags;
        result.coherent = static_cast<bool>(flags & Property::eHostCoherent);
        const bool map =
            use == MemoryUse::device ? static_cast<bool>(flags & Property::eHostCached) : use != MemoryUse::unmapped;
        if (map) result.mapped = static_cast<std::byte*>(result.memory.mapMemory(0, VK_WHOLE_SIZE));
        return result;
    });
}

BufferAllocation create_buffer(const Context& context, std::uint64_t size, vk::BufferUsageFlags usage, MemoryUse use,
                               std::string_view label) {
    BufferAllocation result;
    guarded(fmt::format("creating the buffer '{}' of {} bytes", label, size),
            [&] { result.buffer = vk::raii::Buffer(context.device, vk::BufferCreateInfo({}, size, usage)); });
    result.allocation = allocate(context, result.buffer.getMemoryRequirements(), use, label);
    guarded(fmt::format("binding the memory of '{}'", label),
            [&] { result.buffer.bindMemory(*result.allocation.memory, 0); });
    set_name(context, result.buffer, label);
    return result;
}

ImageAllocation create_image(const Context& context, const vk::ImageCreateInfo& info, std::string_view label) {
    ImageAllocation result;
    guarded(fmt::format("creating the image '{}' of {} x {} pixels", label, info.extent.width, info.extent.height),
            [&] { result.image = vk::raii::Image(context.device, info); });
    result.allocation = allocate(context, result.image.getMemoryRequirements(), MemoryUse::unmapped, label);
    guarded(fmt::format("binding the memory of '{}'", label),
            [&] { result.image.bindMemory(*result.allocation.memory, 0); });
    set_name(context, result.image, label);
    return result;
}

void flush(const Context& context, const Allocation& allocation, std::uint64_t offset, std::uint64_t size) {
    if (allocation.coherent || size == 0) return;
    guarded("flushing mapped memory",
            [&] { context.device.flushMappedMemoryRanges(atoms(context, allocation, offset, size)); });
}

void invalidate(const Context& context, const Allocation& allocation, std::uint64_t offset, std::uint64_t size) {
    if (allocation.coherent || size == 0) return;
    guarded("reading back mapped memory",
            [&] { context.device.invalidateMappedMemoryRanges(atoms(context, allocation, offset, size)); });
}

}  // namespace tessera::backends::vulkan
