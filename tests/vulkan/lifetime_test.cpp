// What the backend makes, reuses and lets go.
#include "vulkan/each_device.hpp"

namespace tessera::test {
namespace {

using gpu::BufferUsage;

TEST(VulkanLifetime, SteadyStateMakesNothing) {
    each_device([](Opened& on) {
        const gpu::Buffer a = make_buffer(on.device, "a", std::vector<float>(256, 1.0f));
        const gpu::Buffer b = make_buffer(on.device, "b", std::vector<float>(256, 0.0f));
        const Scale there(on.device, a, b, 256, 0.5f), back(on.device, b, a, 256, 2.0f);
        const std::vector<float> ones(256, 1.0f);
        const auto frame = [&] {
            on.device.queue().write_buffer(a, 0, std::as_bytes(std::span(ones)));
            for (int i = 0; i < 10; ++i) {
                gpu::CommandEncoder encoder = on.device.create_command_encoder();
                there.record(encoder);
                back.record(encoder);
                on.device.queue().submit(encoder.finish());
            }
            on.device.queue().write_buffer(b, 0, std::as_bytes(std::span(ones)));  // while the device still works
            EXPECT_EQ(content_of<float>(on.device, a)[0], 31.0f);
        };
        frame();
        frame();
        const auto before = on.counters();
        for (int i = 0; i < 50; ++i)
            frame();
        const auto after = on.counters();
        EXPECT_EQ(after.pipelines, 1u);
        EXPECT_EQ(after.pipelines, before.pipelines);
        EXPECT_EQ(after.allocations, before.allocations);
        EXPECT_EQ(after.descriptor_sets, before.descriptor_sets);
        EXPECT_EQ(after.descriptor_pools, before.descriptor_pools);
        EXPECT_GE(after.submissions, before.submissions + 500);
    });
}

TEST(VulkanLifetime, DestroyedBuffersLiveUntilTheWorkIsDone) {
    each_device([](Opened& on) {
        const gpu::Buffer a = make_buffer(on.device, "a", std::vector<float>(1u << 20, 1.0f));
        const gpu::Buffer result = make_buffer(on.device, "result", std::vector<float>(1u << 20, 0.0f));
        {
            gpu::Buffer between = make_buffer(on.device, "between", std::vector<float>(1u << 20, 0.0f));
            const Scale there(on.device, a, between, 1u << 20, 2.0f), back(on.device, between, result, 1u << 20, 2.0f);
            gpu::CommandEncoder encoder = on.device.create_command_encoder();
            there.record(encoder);
            back.record(encoder);
            on.device.queue().submit(encoder.finish());
            between.destroy();
        }
        EXPECT_EQ(content_of<float>(on.device, result), std::vector<float>(1u << 20, 7.0f));
        on.device.queue().wait();
        EXPECT_EQ(on.counters().kept, 0u);
    });
}

TEST(VulkanLifetime, WorkThatWasNotSentKeepsItsBuffers) {
    const auto devices = backends::vulkan::list().devices;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        Opened on(i, vulkan::HostAccess::staged);
        gpu::Buffer buffer = make_buffer(on.device, "written", std::vector<float>(256, 1.0f));  // recorded, not sent
        buffer.destroy();
        EXPECT_EQ(on.counters().kept, 1u);
        on.device.queue().wait();
        EXPECT_EQ(on.counters().kept, 0u);
    }
    expect_no_messages();
}

TEST(VulkanLifetime, ADeviceMayCloseWithWorkUnderWay) {
    each_device([](Opened& on) {
        const gpu::Buffer a = make_buffer(on.device, "a", std::vector<float>(1u << 20, 1.0f));
        const gpu::Buffer b = make_buffer(on.device, "b", std::vector<float>(1u << 20, 1.0f));
        const Scale there(on.device, a, b, 1u << 20, 2.0f);
        gpu::CommandEncoder encoder = on.device.create_command_encoder();
        for (int i = 0; i < 20; ++i)
            there.record(encoder);
        on.device.queue().submit(encoder.finish());
        const std::vector<float> more(256, 2.0f);
        on.device.queue().write_buffer(a, 0, std::as_bytes(std::span(more)));  // and an upload that is never sent
    });
}

TEST(VulkanLifetime, DescriptorSetsAreUsedAgain) {
    each_device([](Opened& on) {
        const gpu::Buffer a = make_buffer(on.device, "a", std::vector<float>(64, 1.0f));
        const gpu::Buffer b = make_buffer(on.device, "b", std::vector<float>(64, 0.0f));
        {
            std::vector<Scale> many;
            for (int i = 0; i < 200; ++i)
                many.emplace_back(on.device, a, b, 64, 2.0f);
        }
        const auto before = on.counters();
        EXPECT_GE(before.descriptor_pools, 1u);  // lavapipe lets a pool grow
        for (int i = 0; i < 400; ++i)
            Scale(on.device, a, b, 64, 2.0f);
        EXPECT_EQ(on.counters().descriptor_pools, before.descriptor_pools);
    });
}

TEST(VulkanLifetime, TwoDevicesOfOneKindDoNotMeet) {
    each_device([](Opened& first) {
        Opened second(0, vulkan::HostAccess::automatic);
        const gpu::Buffer a = make_buffer(first.device, "a", std::vector<float>(64, 1.0f));
        const gpu::Buffer b = make_buffer(second.device, "b", std::vector<float>(64, 2.0f));
        EXPECT_EQ(content_of<float>(first.device, a)[0], 1.0f);
        EXPECT_EQ(content_of<float>(second.device, b)[0], 2.0f);
    });
}

}  // namespace
}  // namespace tessera::test
