#include "gpu/validation.hpp"

#include <algorithm>

namespace tessera::gpu {

namespace {

/// One binding together with all that its error sentences name.
struct Slot {
    const Kernel& kernel;
    const KernelBinding& wanted;
    const Binding& given;
    const detail::BufferState& buffer;
    std::uint64_t size;  // resolved, bytes

    template <typename... Args>
    [[noreturn]] void refuse(fmt::format_string<Args...> rest, Args&&... args) const {
        detail::refuse("create_bind_group of kernel '{}' got buffer '{}' in slot {} {}.", kernel.name,
                       buffer.descriptor.label, wanted.slot, fmt::format(rest, std::forward<Args>(args)...));
    }
};

/// A uniform without a size takes the kernel's struct, so that dynamic offsets can walk the buffer.
std::uint64_t resolved_size(const KernelBinding& wanted, const Binding& given, std::uint64_t buffer_size) {
    if (given.size != 0) {
        return given.size;
    }
    if (wanted.kind == BindingKind::uniform) {
        return wanted.size;
    }
    return given.offset < buffer_size ? buffer_size - given.offset : 0;
}

void check_binding(const Slot& slot, const Limits& limits) {
    const bool uniform = slot.wanted.kind == BindingKind::uniform;
    const std::uint64_t alignment = uniform ? limits.uniform_offset_alignment : limits.storage_offset_alignment;
    const std::uint64_t most = uniform ? limits.max_uniform_binding_size : limits.max_storage_binding_size;
    const std::uint64_t buffer_size = slot.buffer.descriptor.size;
    if (slot.given.offset % alignment != 0) {
        slot.refuse("at offset {}, which is not a multiple of the device's {}", slot.given.offset, alignment);
    }
    if (slot.given.offset > buffer_size || slot.size > buffer_size - slot.given.offset) {
        slot.refuse("over {} bytes from offset {}, but it has only {} bytes", slot.size, slot.given.offset,
                    buffer_size);
    }
    if (slot.size < slot.wanted.size) {
        slot.refuse("over {} bytes, but the kernel needs at least {}", slot.size, slot.wanted.size);
    }
    if (slot.size % 4 != 0) {
        slot.refuse("over {} bytes, which is not a multiple of 4", slot.size);
    }
    if (slot.size > most) {
        slot.refuse("over {} bytes, more than the device's {} per binding", slot.size, most);
    }
}

/// Kernels may assume that what they write is reached through one name only.
void check_aliases(const Kernel& kernel, std::span<const Binding> bindings) {
    for (std::size_t i = 0; i < bindings.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (bindings[i].buffer.state_ == bindings[j].buffer.state_ &&
                (kernel.bindings[i].kind == BindingKind::write_storage ||
                 kernel.bindings[j].kind == BindingKind::write_storage)) {
                detail::refuse(
                    "create_bind_group of kernel '{}' got buffer '{}' in slots {} and {}, one of which is "
                    "written.",
                    kernel.name, bindings[i].buffer.label(), j, i);
            }
        }
    }
}

}  // namespace

BindGroup Device::create_bind_group(const ComputePipeline& pipeline, std::span<const Binding> bindings) {
    detail::not_null(state_, "create_bind_group", "device");
    detail::PipelineState& owner = detail::not_null(pipeline.state_, "create_bind_group", "pipeline");
    const Kernel& kernel = owner.kernel;
    if (owner.device != state_.get()) {
        detail::refuse("create_bind_group got the pipeline of kernel '{}', which belongs to another device ({}).",
                       kernel.name, owner.device->backend->info().id);
    }
    if (bindings.size() != kernel.bindings.size()) {
        detail::refuse("create_bind_group of kernel '{}' got {} bindings, but the kernel has {}.", kernel.name,
                       bindings.size(), kernel.bindings.size());
    }
    auto group = std::make_shared<detail::BindGroupState>();
    group->device = state_;
    group->pipeline = &owner;
    std::vector<BoundBuffer> resources;
    for (std::size_t i = 0; i < bindings.size(); ++i) {
        const Binding& given = bindings[i];
        const KernelBinding& wanted = kernel.bindings[i];
        const bool uniform = wanted.kind == BindingKind::uniform;
        const std::string call = fmt::format("create_bind_group of kernel '{}' (slot {})", kernel.name, i);
        detail::BufferState& buffer =
            detail::require_buffer(given.buffer, *state_, call, uniform ? BufferUsage::uniform : BufferUsage::storage);
        const Slot slot{kernel, wanted, given, buffer, resolved_size(wanted, given, buffer.descriptor.size)};
        check_binding(slot, limits());
        if (uniform) {
            group->uniform_slot = wanted.slot;
            group->largest_uniform_offset = buffer.descriptor.size - given.offset - slot.size;
        }
        group->buffers.push_back(given.buffer.state_);
        resources.push_back({buffer.object.get(), given.offset, slot.size});
    }
    check_aliases(kernel, bindings);
    group->object = state_->backend->create_bind_group(*owner.object, resources);
    BindGroup handle;
    handle.state_ = std::move(group);
    return handle;
}

BindGroup Device::create_bind_group(const ComputePipeline& pipeline, std::initializer_list<Binding> bindings) {
    return create_bind_group(pipeline, std::span<const Binding>(bindings.begin(), bindings.size()));
}

}  // namespace tessera::gpu
