#include "gpu/device.hpp"

#include "gpu/validation.hpp"

namespace tessera::gpu {

Device::Device(std::unique_ptr<Backend> backend) : state_(std::make_shared<detail::DeviceState>()) {
    if (backend == nullptr) {
        detail::refuse("Device needs a backend, but got a null pointer.");
    }
    state_->backend = std::move(backend);
}

const DeviceInfo& Device::info() const {
    return detail::not_null(state_, "Device::info", "device").backend->info();
}

const Traffic& Device::traffic() const {
    return detail::not_null(state_, "Device::traffic", "device").traffic;
}

Backend& Device::backend() const {
    return *detail::not_null(state_, "Device::backend", "device").backend;
}

Queue Device::queue() const {
    detail::not_null(state_, "Device::queue", "device");
    Queue queue;
    queue.state_ = state_;
    return queue;
}

CommandEncoder Device::create_command_encoder() {
    detail::not_null(state_, "create_command_encoder", "device");
    CommandEncoder encoder;
    encoder.state_ = std::make_shared<detail::EncoderState>();
    encoder.state_->device = state_;
    encoder.state_->recording.number = ++state_->recordings;
    return encoder;
}

}  // namespace tessera::gpu
