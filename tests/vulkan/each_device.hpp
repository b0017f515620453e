// Runs a test on every Vulkan device, with and without staging, and fails on any message of the validation layer.
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "backends/vulkan/counters.hpp"
#include "backends/vulkan/validation.hpp"
#include "backends/vulkan/vulkan_backend.hpp"
#include "gpu/device.hpp"
#include "gpu/kernel_catalog.hpp"
#include "support/environment.hpp"

namespace tessera::test {

namespace vulkan = backends::vulkan;

/// A Vulkan device, and the backend under it for its counters.
struct Opened {
    const gpu::Backend* backend;
    gpu::Device device;

    Opened(std::size_t index, vulkan::HostAccess access) : Opened(vulkan::open(index, access)) {}
    vulkan::Counters counters() const { return vulkan::counters(*backend); }

private:
    explicit Opened(std::unique_ptr<gpu::Backend> made) : backend(made.get()), device(std::move(made)) {}
};

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

inline void expect_no_messages() {
    for (const std::string& message : vulkan::take_validation_messages())
        ADD_FAILURE() << message;
}

inline void each_device(const std::function<void(Opened&)>& test) {
    const auto devices = vulkan::list().devices;
    if (devices.empty() && everything_required()) FAIL() << "no Vulkan device";
    if (devices.empty()) GTEST_SKIP() << "needs a Vulkan device";
    for (std::size_t i = 0; i < devices.size(); ++i) {
        for (const auto access : {vulkan::HostAccess::automatic, vulkan::HostAccess::staged}) {
            SCOPED_TRACE(devices[i].name + (access == vulkan::HostAccess::staged ? ", staged" : ""));
            {
                Opened opened(i, access);
                test(opened);
            }
            expect_no_messages();
        }
    }
}

template <typename T>
gpu::Buffer make_buffer(gpu::Device& device, const std::string& label, const std::vector<T>& content,
                        gpu::BufferUsage usage = gpu::BufferUsage::storage) {
    const auto bytes = std::as_bytes(std::span(content));
    gpu::Buffer buffer = device.create_buffer(
        {label, bytes.size(), usage | gpu::BufferUsage::copy_source | gpu::BufferUsage::copy_destination});
    device.queue().write_buffer(buffer, 0, bytes);
    return buffer;
}

template <typename T>
std::vector<T> content_of(gpu::Device& device, const gpu::Buffer& buffer) {
    std::vector<T> content(buffer.size() / sizeof(T));
    device.queue().read_buffer(buffer, 0, std::as_writable_bytes(std::span(content)));
    return content;
}

/// The parameters of the kernel scale_probe: result[i] = source[i] * factor + 1 for i < count.
struct ScaleParameters {
    std::uint32_t count;
    float factor;
};

/// source -> result through scale_probe, `count` items.
class Scale {
public:
    Scale(gpu::Device& device, const gpu::Buffer& source, const gpu::Buffer& result, std::uint32_t count, float factor)
        : pipeline_(device.create_compute_pipeline(gpu::find_kernel("scale_probe"))),
          parameters_(make_buffer<ScaleParameters>(device, "parameters", {{count, factor}}, gpu::BufferUsage::uniform)),
          group_(device.create_bind_group(pipeline_, {{source}, {result}, {parameters_}})),
          groups_((count + 63) / 64) {}

    void record(gpu::CommandEncoder& encoder) const {
        gpu::ComputePass pass = encoder.begin_compute_pass();
        pass.set_pipeline(pipeline_);
        pass.set_bind_group(group_);
        pass.dispatch_workgroups(groups_);
        pass.end();
    }
    void record_indirect(gpu::CommandEncoder& encoder, const gpu::Buffer& arguments) const {
        gpu::ComputePass pass = encoder.begin_compute_pass();
        pass.set_pipeline(pipeline_);
        pass.set_bind_group(group_);
        pass.dispatch_workgroups_indirect(arguments, 0);
        pass.end();
    }

private:
    gpu::ComputePipeline pipeline_;
    gpu::Buffer parameters_;
    gpu::BindGroup group_;
    std::uint32_t groups_;
};

}  // namespace tessera::test
