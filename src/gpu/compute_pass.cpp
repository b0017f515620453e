#include "gpu/validation.hpp"

#include <algorithm>

namespace tessera::gpu {

namespace {

/// The state of the encoder whose open pass this is.
detail::EncoderState& open(const ComputePass& pass, std::string_view call) {
    detail::EncoderState& state = detail::not_null(pass.state_, call, "compute pass");
    if (state.open_pass != pass.number_) {
        detail::refuse("{} came after the end of compute pass {}; begin a new pass.", call, pass.number_);
    }
    return state;
}

/// The state of an open pass that has all that a dispatch needs.
detail::EncoderState& ready(const ComputePass& pass, std::string_view call) {
    detail::EncoderState& state = open(pass, call);
    if (state.pipeline == nullptr) {
        detail::refuse("{} came before set_pipeline in compute pass {}.", call, pass.number_);
    }
    const std::string& kernel = state.pipeline->kernel.name;
    if (state.bind_group == nullptr) {
        detail::refuse("{} of kernel '{}' came before set_bind_group in compute pass {}.", call, kernel, pass.number_);
    }
    if (state.bind_group->pipeline != state.pipeline) {
        detail::refuse("{} of kernel '{}' came with a bind group made for kernel '{}'.", call, kernel,
                       state.bind_group->pipeline->kernel.name);
    }
    return state;
}

}  // namespace

void ComputePass::set_pipeline(const ComputePipeline& pipeline) {
    constexpr std::string_view call = "set_pipeline";
    detail::EncoderState& state = open(*this, call);
    const detail::PipelineState& next = detail::not_null(pipeline.state_, call, "pipeline");
    if (next.device != state.device.get()) {
        detail::refuse("{} got the pipeline of kernel '{}', which belongs to another device ({}).", call,
                       next.kernel.name, next.device->backend->info().id);
    }
    state.pipeline = &next;  // pipelines live as long as the device, which the encoder owns
}

void ComputePass::set_bind_group(const BindGroup& group, std::uint32_t uniform_offset) {
    constexpr std::string_view call = "set_bind_group";
    detail::EncoderState& state = open(*this, call);
    const detail::BindGroupState& next = detail::not_null(group.state_, call, "bind group");
    const std::string& kernel = next.pipeline->kernel.name;
    if (next.device != state.device) {
        detail::refuse("{} got a bind group of kernel '{}' that belongs to another device ({}).", call, kernel,
                       next.device->backend->info().id);
    }
    for (const auto& buffer : next.buffers) {
        if (buffer->object == nullptr) {
            detail::refuse("{} got a bind group of kernel '{}' whose buffer '{}' was destroyed.", call, kernel,
                           buffer->descriptor.label);
        }
    }
    const std::uint32_t alignment = state.device->backend->info().limits.uniform_offset_alignment;
    if (uniform_offset % alignment != 0) {
        detail::refuse("{} got uniform offset {} for kernel '{}', which is not a multiple of the device's {}.", call,
                       uniform_offset, kernel, alignment);
    }
    if (uniform_offset != 0 && !next.uniform_slot) {
        detail::refuse("{} got uniform offset {} for kernel '{}', which has no uniform binding.", call, uniform_offset,
                       kernel);
    }
    if (uniform_offset > next.largest_uniform_offset) {
        detail::refuse("{} got uniform offset {} for kernel '{}', which leaves buffer '{}'; the largest is {}.", call,
                       uniform_offset, kernel, next.buffers[*next.uniform_slot]->descriptor.label,
                       next.largest_uniform_offset);
    }
    state.recording.hold(state.recording.bind_groups, group.state_);
    state.bind_group = &next;
    state.uniform_offset = uniform_offset;
}

void ComputePass::dispatch_workgroups(std::uint32_t groups_x, std::uint32_t groups_y) {
    detail::EncoderState& state = ready(*this, "dispatch_workgroups");
    detail::require_groups(*state.device, state.pipeline->kernel, groups_x, groups_y);
    if (groups_x != 0 && groups_y != 0) {
        state.recording.commands.emplace_back(Dispatch{state.pipeline->object.get(), state.bind_group->object.get(),
                                                       state.uniform_offset, groups_x, groups_y});
    }
}

void ComputePass::dispatch_workgroups_indirect(const Buffer& arguments, std::uint64_t offset) {
    constexpr std::string_view call = "dispatch_workgroups_indirect";
    detail::EncoderState& state = ready(*this, call);
    const detail::BufferState& buffer = detail::require_buffer(arguments, *state.device, call, BufferUsage::indirect);
    detail::require_range(buffer, call, offset, 3 * sizeof(std::uint32_t));
    const Kernel& kernel = state.pipeline->kernel;
    for (std::size_t slot = 0; slot < kernel.bindings.size(); ++slot) {
        if (kernel.bindings[slot].kind == BindingKind::write_storage &&
            state.bind_group->buffers[slot] == arguments.state_) {
            detail::refuse("{} of kernel '{}' takes its counts from buffer '{}', which the kernel writes in slot {}.",
                           call, kernel.name, buffer.descriptor.label, slot);
        }
    }
    state.recording.hold(state.recording.buffers, arguments.state_);
    state.recording.commands.emplace_back(DispatchIndirect{state.pipeline->object.get(), state.bind_group->object.get(),
                                                           state.uniform_offset, buffer.object.get(), offset});
}

void ComputePass::end() {
    open(*this, "end").open_pass = 0;
}

}  // namespace tessera::gpu
