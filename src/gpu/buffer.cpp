#include "gpu/validation.hpp"

namespace tessera::gpu {

namespace {

constexpr BufferUsage every_usage = BufferUsage::storage | BufferUsage::uniform | BufferUsage::copy_source |
                                    BufferUsage::copy_destination | BufferUsage::indirect | BufferUsage::query_resolve;

void check_descriptor(const BufferDescriptor& descriptor, const Limits& limits) {
    const auto& [label, size, usage] = descriptor;
    if (size == 0) {
        detail::refuse("create_buffer got a size of 0 bytes for buffer '{}'; the smallest is 4.", label);
    }
    if (size % 4 != 0) {
        detail::refuse("create_buffer got a size of {} bytes for buffer '{}', which is not a multiple of 4.", size,
                       label);
    }
    if (size > limits.max_buffer_size) {
        detail::refuse("create_buffer got a size of {} bytes for buffer '{}', more than the device's {}.", size, label,
                       limits.max_buffer_size);
    }
    if (usage == BufferUsage::none || !has(every_usage, usage)) {
        detail::refuse("create_buffer got usage {:#x} for buffer '{}'; name at least one flag of BufferUsage.",
                       static_cast<std::uint32_t>(usage), label);
    }
}

}  // namespace

Buffer Device::create_buffer(const BufferDescriptor& descriptor) {
    detail::not_null(state_, "create_buffer", "device");
    check_descriptor(descriptor, limits());
    Buffer buffer;
    buffer.state_ = std::make_shared<detail::BufferState>();
    buffer.state_->device = state_;
    buffer.state_->descriptor = descriptor;
    buffer.state_->object = state_->backend->create_buffer(descriptor);
    return buffer;
}

Buffer create_filled_buffer(Device& device, const char* label, std::span<const std::byte> data) {
    Buffer buffer = device.create_buffer({label, data.size(), BufferUsage::storage | BufferUsage::copy_destination});
    device.queue().write_buffer(buffer, 0, data);
    return buffer;
}

std::uint64_t Buffer::size() const {
    return detail::not_null(state_, "Buffer::size", "buffer").descriptor.size;
}

const std::string& Buffer::label() const {
    return detail::not_null(state_, "Buffer::label", "buffer").descriptor.label;
}

BackendObject& Buffer::object() const {
    const detail::BufferState& state = detail::not_null(state_, "Buffer::object", "buffer");
    if (state.object == nullptr)
        detail::refuse("Buffer::object was called on buffer '{}', which was destroyed.", state.descriptor.label);
    return *state.object;
}

void Buffer::destroy() {
    detail::not_null(state_, "Buffer::destroy", "buffer").object.reset();
}

}  // namespace tessera::gpu
