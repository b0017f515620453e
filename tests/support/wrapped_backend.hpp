// A backend that hands everything on to the reference, so that a test can lie about the device or spoil its results.
#pragma once

#include "backends/reference/reference_backend.hpp"
#include "gpu/device.hpp"

#include <functional>
#include <map>
#include <string>

namespace tessera::test {

/// Derive and override what is to be different.
class WrappedBackend : public gpu::Backend {
public:
    WrappedBackend() : inner_(backends::reference::open(0)), info_(inner_->info()) {}

    const gpu::DeviceInfo& info() const override { return info_; }
    std::unique_ptr<gpu::BackendObject> create_buffer(const gpu::BufferDescriptor& descriptor) override {
        return inner_->create_buffer(descriptor);
    }
    std::unique_ptr<gpu::BackendObject> create_pipeline(const gpu::Kernel& kernel) override {
        auto pipeline = inner_->create_pipeline(kernel);
        kernels_[pipeline.get()] = &kernel;
        return pipeline;
    }
    std::unique_ptr<gpu::BackendObject> create_bind_group(gpu::BackendObject& pipeline,
                                                          std::span<const gpu::BoundBuffer> resources) override {
        auto group = inner_->create_bind_group(pipeline, resources);
        groups_[group.get()].assign(resources.begin(), resources.end());
        return group;
    }
    std::unique_ptr<gpu::BackendObject> create_query_set(std::uint32_t count) override {
        return inner_->create_query_set(count);
    }
    void write_buffer(gpu::BackendObject& buffer, std::uint64_t offset, std::span<const std::byte> data) override {
        inner_->write_buffer(buffer, offset, data);
    }
    void read_buffer(gpu::BackendObject& buffer, std::uint64_t offset, std::span<std::byte> data) override {
        inner_->read_buffer(buffer, offset, data);
    }
    void submit(std::span<const gpu::Command> commands) override { inner_->submit(commands); }
    void wait() override { inner_->wait(); }

protected:
    gpu::DeviceInfo& changeable_info() { return info_; }
    gpu::Backend& inner() { return *inner_; }
    const gpu::Kernel& kernel_of(const gpu::Dispatch& dispatch) const { return *kernels_.at(dispatch.pipeline); }
    const std::vector<gpu::BoundBuffer>& buffers_of(const gpu::Dispatch& dispatch) const {
        return groups_.at(dispatch.bind_group);
    }

private:
    std::unique_ptr<gpu::Backend> inner_;
    gpu::DeviceInfo info_;
    std::map<const gpu::BackendObject*, const gpu::Kernel*> kernels_;
    std::map<const gpu::BackendObject*, std::vector<gpu::BoundBuffer>> groups_;
};

}  // namespace tessera::test
