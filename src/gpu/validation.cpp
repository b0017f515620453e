#include "gpu/validation.hpp"

#include <limits>

namespace tessera::gpu::detail {

std::string_view usage_name(BufferUsage flag) {
    switch (flag) {
        case BufferUsage::none:
            return "none";
        case BufferUsage::storage:
            return "storage";
        case BufferUsage::uniform:
            return "uniform";
        case BufferUsage::copy_source:
            return "copy_source";
        case BufferUsage::copy_destination:
            return "copy_destination";
        case BufferUsage::indirect:
            return "indirect";
        case BufferUsage::query_resolve:
            return "query_resolve";
    }
    return "unknown";
}

BufferState& require_buffer(const Buffer& buffer, const DeviceState& device, std::string_view call, BufferUsage flag) {
    BufferState& state = not_null(buffer.state_, call, "buffer");
    const std::string& label = state.descriptor.label;
    if (state.device.get() != &device) {
        refuse("{} got buffer '{}', which belongs to another device ({}).", call, label,
               state.device->backend->info().id);
    }
    if (state.object == nullptr) {
        refuse("{} got buffer '{}', which was destroyed.", call, label);
    }
    if (!has(state.descriptor.usage, flag)) {
        refuse("{} needs usage {} on buffer '{}', which was created without it.", call, usage_name(flag), label);
    }
    return state;
}

QuerySetState& require_query_set(const QuerySet& queries, const DeviceState& device, std::string_view call) {
    QuerySetState& state = not_null(queries.state_, call, "query set");
    if (state.device.get() != &device) {
        refuse("{} got a query set of {} timestamps that belongs to another device ({}).", call, state.count,
               state.device->backend->info().id);
    }
    return state;
}

void require_range(const BufferState& buffer, std::string_view call, std::uint64_t offset, std::uint64_t size,
                   std::uint64_t alignment) {
    const BufferDescriptor& descriptor = buffer.descriptor;
    if (offset % alignment != 0) {
        refuse("{} got offset {} in buffer '{}', which is not a multiple of {}.", call, offset, descriptor.label,
               alignment);
    }
    if (size % alignment != 0) {
        refuse("{} got a size of {} bytes in buffer '{}', which is not a multiple of {}.", call, size, descriptor.label,
               alignment);
    }
    if (offset > descriptor.size || size > descriptor.size - offset) {
        refuse("{} reaches {} bytes from offset {} in buffer '{}', which has only {} bytes.", call, size, offset,
               descriptor.label, descriptor.size);
    }
}

void require_groups(const DeviceState& device, const Kernel& kernel, std::uint32_t groups_x, std::uint32_t groups_y) {
    const std::uint32_t most = device.backend->info().limits.max_workgroups_per_dimension;
    if (groups_x > most || groups_y > most) {
        refuse("dispatch_workgroups of kernel '{}' got {} x {} groups, more than the device's {} per dimension.",
               kernel.name, groups_x, groups_y, most);
    }
    const std::uint64_t groups = std::uint64_t{groups_x} * groups_y;
    if (groups > std::numeric_limits<std::uint32_t>::max() / workgroup_size) {
        refuse("dispatch_workgroups of kernel '{}' got {} x {} groups, whose items a 32-bit index cannot count.",
               kernel.name, groups_x, groups_y);
    }
}

}  // namespace tessera::gpu::detail
