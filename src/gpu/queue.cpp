#include "gpu/validation.hpp"

#include <algorithm>

namespace tessera::gpu {

namespace {

void check_buffer_lives(const detail::BufferState& buffer) {
    if (buffer.object == nullptr) {
        detail::refuse("submit got commands that use buffer '{}', which was destroyed after they were recorded.",
                       buffer.descriptor.label);
    }
}

void check_objects_live(const detail::Recording& recording) {
    for (const auto& buffer : recording.buffers) {
        check_buffer_lives(*buffer);
    }
    for (const auto& group : recording.bind_groups) {
        for (const auto& buffer : group->buffers) {
            check_buffer_lives(*buffer);
        }
    }
}

void check_timestamps_written(const detail::Recording& recording) {
    for (const detail::QueryUse& use : recording.queries) {
        for (std::uint32_t i = 0; i < use.set->count; ++i) {
            if (use.awaited[i] && !use.set->written[i]) {
                detail::refuse(
                    "submit got commands that resolve timestamp {} of a query set of {}, which nothing "
                    "has written.",
                    i, use.set->count);
            }
        }
    }
}

void mark_timestamps_written(const detail::Recording& recording) {
    for (const detail::QueryUse& use : recording.queries) {
        for (std::uint32_t i = 0; i < use.set->count; ++i) {
            use.set->written[i] = use.set->written[i] || use.written[i];
        }
    }
}

std::uint64_t count_dispatches(const detail::Recording& recording) {
    return static_cast<std::uint64_t>(std::ranges::count_if(recording.commands, [](const Command& command) {
        return std::holds_alternative<Dispatch>(command) || std::holds_alternative<DispatchIndirect>(command);
    }));
}

}  // namespace

void Queue::submit(const CommandBuffer& commands) {
    detail::DeviceState& device = detail::not_null(state_, "submit", "queue");
    detail::CommandBufferState& buffer = detail::not_null(commands.state_, "submit", "command buffer");
    if (buffer.device != state_) {
        detail::refuse("submit got a command buffer that belongs to another device ({}).",
                       buffer.device->backend->info().id);
    }
    if (buffer.submitted) {
        detail::refuse("submit got a command buffer that was submitted before; record it again.");
    }
    check_objects_live(buffer.recording);
    check_timestamps_written(buffer.recording);
    buffer.submitted = true;
    const detail::Recording recording = std::move(buffer.recording);  // let go of its objects on return
    mark_timestamps_written(recording);
    if (!recording.commands.empty()) {
        ++device.traffic.submits;
        device.traffic.dispatches += count_dispatches(recording);
        device.backend->submit(recording.commands);
    }
}

void Queue::write_buffer(const Buffer& buffer, std::uint64_t offset, std::span<const std::byte> data) {
    detail::DeviceState& device = detail::not_null(state_, "write_buffer", "queue");
    const detail::BufferState& target =
        detail::require_buffer(buffer, device, "write_buffer", BufferUsage::copy_destination);
    detail::require_range(target, "write_buffer", offset, data.size());
    if (!data.empty()) {
        device.traffic.uploaded += data.size();
        device.backend->write_buffer(*target.object, offset, data);
    }
}

void Queue::read_buffer(const Buffer& buffer, std::uint64_t offset, std::span<std::byte> data) {
    detail::DeviceState& device = detail::not_null(state_, "read_buffer", "queue");
    const detail::BufferState& source = detail::require_buffer(buffer, device, "read_buffer", BufferUsage::copy_source);
    detail::require_range(source, "read_buffer", offset, data.size());
    if (data.empty()) {
        device.backend->wait();
    } else {
        device.traffic.read += data.size();
        device.backend->read_buffer(*source.object, offset, data);
    }
}

void Queue::wait() {
    detail::not_null(state_, "Queue::wait", "queue").backend->wait();
}

}  // namespace tessera::gpu
