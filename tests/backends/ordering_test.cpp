// Every command sees the writes of those before it, within one command buffer and across submits.
#include "backends/device_suite.hpp"

namespace tessera::backends {
namespace {

using OrderingTest = DeviceTest;

TEST_P(OrderingTest, ADispatchSeesTheDispatchBefore) {
    constexpr std::uint32_t count = 10'000;
    constexpr int rounds = 40;
    std::vector<float> expected = noise(count);
    const gpu::Buffer a = upload("a", expected);
    const gpu::Buffer b = make("b", count * 4);
    const gpu::Buffer uniform = parameters(count, 0.9f);
    const gpu::BindGroup there = device.create_bind_group(scale, {{a}, {b}, {uniform}});
    const gpu::BindGroup back = device.create_bind_group(scale, {{b}, {a}, {uniform}});
    gpu::CommandEncoder encoder = device.create_command_encoder();
    gpu::ComputePass pass = encoder.begin_compute_pass();
    pass.set_pipeline(scale);
    for (int round = 0; round < rounds; ++round) {
        pass.set_bind_group(round % 2 == 0 ? there : back);
        pass.dispatch_workgroups((count + gpu::workgroup_size - 1) / gpu::workgroup_size);
        expected = scaled(expected, 0.9f);
    }
    pass.end();
    queue.submit(encoder.finish());
    EXPECT_TRUE(download<float>(a, count) == expected);
}

TEST_P(OrderingTest, FillsCopiesAndDispatchesInterleave) {
    constexpr std::uint32_t count = 5'000;
    const gpu::Buffer a = make("a", count * 4);
    const gpu::Buffer b = make("b", count * 4);
    const gpu::Buffer first = make("first", count * 4);
    const gpu::BindGroup group = device.create_bind_group(scale, {{a}, {b}, {parameters(count, 2.0f)}});
    gpu::CommandEncoder encoder = device.create_command_encoder();
    encoder.fill_buffer(a, 0, count * 4, std::bit_cast<std::uint32_t>(1.0f));
    record_scale(encoder, group, count);                       // b = 3
    encoder.copy_buffer_to_buffer(b, 0, first, 0, count * 4);  // first = 3
    encoder.fill_buffer(a, 0, count * 4, std::bit_cast<std::uint32_t>(10.0f));
    record_scale(encoder, group, count);                   // b = 21; must not overtake the copy
    encoder.copy_buffer_to_buffer(b, 0, a, 0, count * 4);  // a = 21
    record_scale(encoder, group, count);                   // b = 43
    queue.submit(encoder.finish());
    EXPECT_EQ(download<float>(first, count), std::vector<float>(count, 3.0f));
    EXPECT_EQ(download<float>(a, count), std::vector<float>(count, 21.0f));
    EXPECT_EQ(download<float>(b, count), std::vector<float>(count, 43.0f));
}

TEST_P(OrderingTest, WritesKeepTheirPlaceBetweenSubmits) {
    constexpr std::uint32_t count = 50'000;
    const std::vector<float> input = noise(count);
    const gpu::Buffer in = upload("in", input);
    const gpu::Buffer uniform = parameters(count, 0.0f);
    std::vector<gpu::Buffer> outputs;
    for (int i = 0; i < 8; ++i) {
        write<ScaleProbeParams>(uniform, {{count, static_cast<float>(i)}});
        outputs.push_back(make("out", count * 4));
        run_scale(device.create_bind_group(scale, {{in}, {outputs.back()}, {uniform}}), count);
    }
    for (int i = 0; i < 8; ++i) {
        EXPECT_TRUE(download<float>(outputs[i], count) == scaled(input, static_cast<float>(i))) << i;
    }
}

TEST_P(OrderingTest, ReusesOneBindGroupThousandsOfTimes) {
    constexpr std::uint32_t dispatches = 2'000;
    const gpu::Buffer a = make("a", 256);
    const gpu::Buffer b = make("b", 256);
    const gpu::Buffer uniform = parameters(64, 1.0f);
    const gpu::BindGroup there = device.create_bind_group(scale, {{a}, {b}, {uniform}});
    const gpu::BindGroup back = device.create_bind_group(scale, {{b}, {a}, {uniform}});
    gpu::CommandEncoder encoder = device.create_command_encoder();
    gpu::ComputePass pass = encoder.begin_compute_pass();
    pass.set_pipeline(scale);
    for (std::uint32_t i = 0; i < dispatches / 2; ++i) {
        pass.set_bind_group(there);
        pass.dispatch_workgroups(1);
        pass.set_bind_group(back);
        pass.dispatch_workgroups(1);
    }
    pass.end();
    queue.submit(encoder.finish());
    EXPECT_EQ(download<float>(a, 64), std::vector<float>(64, static_cast<float>(dispatches)));
}

TESSERA_ON_EVERY_DEVICE(OrderingTest);

}  // namespace
}  // namespace tessera::backends
