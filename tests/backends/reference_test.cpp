// What only the reference backend promises.
#include "backends/reference/reference_backend.hpp"

#include "backends/device_suite.hpp"
#include "base/error.hpp"

namespace tessera::backends {
namespace {

/// Adds one to each item's word, so that an item that runs twice or not at all shows.
void count_visits(std::uint32_t first, std::uint32_t last, std::byte* const* slots) {
    auto* visits = reinterpret_cast<std::uint32_t*>(slots[0]);
    for (std::uint32_t item = first; item < last; ++item) {
        ++visits[item];
    }
}

class ReferenceTest : public testing::Test {
protected:
    ReferenceTest() {
        kernel.name = "count_visits";
        kernel.bindings = {{0, gpu::BindingKind::write_storage, 4}};
        kernel.reference = count_visits;
    }

    /// Runs the kernel by group counts from a buffer; returns the number of visits of every item.
    std::vector<std::uint32_t> visits(std::vector<std::uint32_t> groups, std::size_t items) {
        using gpu::BufferUsage;
        const gpu::Buffer words =
            device.create_buffer({"visits", items * 4, BufferUsage::storage | BufferUsage::copy_source});
        const gpu::Buffer arguments =
            device.create_buffer({"arguments", 12, BufferUsage::indirect | BufferUsage::copy_destination});
        device.queue().write_buffer(arguments, 0, std::as_bytes(std::span(groups)));
        const gpu::ComputePipeline pipeline = device.create_compute_pipeline(kernel);
        gpu::CommandEncoder encoder = device.create_command_encoder();
        gpu::ComputePass pass = encoder.begin_compute_pass();
        pass.set_pipeline(pipeline);
        pass.set_bind_group(device.create_bind_group(pipeline, {{words}}));
        pass.dispatch_workgroups_indirect(arguments, 0);
        pass.end();
        device.queue().submit(encoder.finish());
        std::vector<std::uint32_t> result(items);
        device.queue().read_buffer(words, 0, std::as_writable_bytes(std::span(result)));
        return result;
    }

    gpu::Device device{reference::open(0)};
    gpu::Kernel kernel;
};

TEST_F(ReferenceTest, RunsEveryItemOnce) {
    for (const std::uint32_t groups : {1u, 2u, 3u, 63u, 1000u, 20'000u}) {
        const std::size_t items = std::size_t{groups} * 3 * gpu::workgroup_size;
        EXPECT_TRUE(visits({groups, 3, 1}, items) == std::vector<std::uint32_t>(items, 1u)) << groups;
    }
}

TEST_F(ReferenceTest, SkipsIndirectDispatchesOverTheLimits) {
    const std::vector<std::uint32_t> none(64, 0u);
    EXPECT_EQ(visits({1, 1, 1}, 64), std::vector<std::uint32_t>(64, 1u));
    for (const std::vector<std::uint32_t>& groups : std::vector<std::vector<std::uint32_t>>{
             {65536, 1, 1}, {1, 65536, 1}, {65535, 65535, 1}, {1, 1, 0}, {1, 1, 2}, {0, 1, 1}, {1, 0, 1}}) {
        EXPECT_EQ(visits(groups, 64), none) << groups[0] << " x " << groups[1] << " x " << groups[2];
    }
}

TEST_F(ReferenceTest, RefusesKernelsWithoutACppForm) {
    kernel.reference = nullptr;
    EXPECT_THROW(device.create_compute_pipeline(kernel), Error);
}

TEST_F(ReferenceTest, IsOneDevice) {
    EXPECT_EQ(reference::list().devices.size(), 1u);
    EXPECT_THROW(reference::open(1), Error);
}

}  // namespace
}  // namespace tessera::backends
