// One suite for every device of this machine: each test of the classes derived from DeviceTest runs on all of them.
#pragma once

#include "backends/registry.hpp"
#include "gpu/kernel_catalog.hpp"
#include "layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <ostream>

namespace tessera::gpu {

/// What GoogleTest prints for a device.
inline void PrintTo(const DeviceInfo& info, std::ostream* out) {
    *out << info.id << " (" << info.name << ")";
}

}  // namespace tessera::gpu

namespace tessera::backends {

using kernels::ScaleProbeParams;

/// What a test writes around an output to see that nothing else is written.
inline constexpr std::uint32_t sentinel = 0xa5a5a5a5;

/// Every usable device; looked up once.
const Inventory& machine();

/// "vulkan_1" for "vulkan:1": what a test is called on that device.
std::string test_name(const testing::TestParamInfo<gpu::DeviceInfo>& device);

/// What scale_probe must give, bit for bit.
std::vector<float> scaled(std::span<const float> input, float factor);

/// `count` floats with full mantissas, so that a contracted or reordered operation shows.
std::vector<float> noise(std::size_t count);

/// Runs on one device, which is opened once for all tests and closed before the process ends.
class DeviceTest : public testing::TestWithParam<gpu::DeviceInfo> {
protected:
    DeviceTest();
    /// Fails the test for every message of the Vulkan validation layer.
    void TearDown() override;

    gpu::Buffer make(const std::string& label, std::uint64_t size, gpu::BufferUsage extra = gpu::BufferUsage::storage) {
        return device.create_buffer(
            {label, size, extra | gpu::BufferUsage::copy_source | gpu::BufferUsage::copy_destination});
    }

    template <typename T>
    void write(const gpu::Buffer& buffer, const std::vector<T>& data, std::uint64_t offset = 0) {
        queue.write_buffer(buffer, offset, std::as_bytes(std::span(data)));
    }

    template <typename T>
    gpu::Buffer upload(const std::string& label, const std::vector<T>& data,
                       gpu::BufferUsage extra = gpu::BufferUsage::storage) {
        gpu::Buffer buffer = make(label, data.size() * sizeof(T), extra);
        write(buffer, data);
        return buffer;
    }

    template <typename T>
    std::vector<T> download(const gpu::Buffer& buffer, std::size_t count, std::uint64_t offset = 0) {
        std::vector<T> data(count);
        queue.read_buffer(buffer, offset, std::as_writable_bytes(std::span(data)));
        return data;
    }

    gpu::Buffer parameters(std::uint32_t count, float factor) {
        return upload<ScaleProbeParams>("parameters", {{count, factor}}, gpu::BufferUsage::uniform);
    }

    /// Records one dispatch of scale_probe over `count` items in one row of groups.
    void record_scale(gpu::CommandEncoder& encoder, const gpu::BindGroup& group, std::uint32_t count,
                      std::uint32_t uniform_offset = 0) {
        gpu::ComputePass pass = encoder.begin_compute_pass();
        pass.set_pipeline(scale);
        pass.set_bind_group(group, uniform_offset);
        pass.dispatch_workgroups((count + gpu::workgroup_size - 1) / gpu::workgroup_size);
        pass.end();
    }

    void run_scale(const gpu::BindGroup& group, std::uint32_t count, std::uint32_t uniform_offset = 0) {
        gpu::CommandEncoder encoder = device.create_command_encoder();
        record_scale(encoder, group, count, uniform_offset);
        queue.submit(encoder.finish());
    }

    gpu::Device device;
    gpu::Queue queue;
    gpu::ComputePipeline scale;
};

}  // namespace tessera::backends

/// Instantiates the suite `name`, a class derived from DeviceTest, for every device.
#define TESSERA_ON_EVERY_DEVICE(name)                                                           \
    INSTANTIATE_TEST_SUITE_P(On, name, testing::ValuesIn(tessera::backends::machine().devices), \
                             tessera::backends::test_name)
