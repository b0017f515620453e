// What is destroyed or dropped right after a submit must not disturb the work that uses it.
#include "backends/device_suite.hpp"

namespace tessera::backends {
namespace {

using LifetimeTest = DeviceTest;

TEST_P(LifetimeTest, BuffersMayBeDestroyedAfterSubmit) {
    constexpr std::uint32_t count = 200'000;
    const std::vector<float> input = noise(count);
    const gpu::Buffer kept = make("kept", count * 4);
    for (int round = 0; round < 6; ++round) {
        gpu::Buffer in = upload("in", input);
        gpu::Buffer out = make("out", count * 4);
        gpu::Buffer uniform = parameters(count, static_cast<float>(round));
        gpu::CommandEncoder encoder = device.create_command_encoder();
        record_scale(encoder, device.create_bind_group(scale, {{in}, {out}, {uniform}}), count);
        encoder.copy_buffer_to_buffer(out, 0, kept, 0, count * 4);
        queue.submit(encoder.finish());
        in.destroy();
        out.destroy();
        uniform.destroy();
        // New memory of the same sizes tempts the device to hand out what is still in use.
        const gpu::Buffer next = upload("next", std::vector<std::uint32_t>(count, sentinel));
        EXPECT_TRUE(download<float>(kept, count) == scaled(input, static_cast<float>(round))) << round;
    }
}

TEST_P(LifetimeTest, HandlesMayBeDroppedAfterSubmit) {
    constexpr std::uint32_t count = 100'000;
    const std::vector<float> input = noise(count);
    const gpu::Buffer in = upload("in", input);
    std::vector<gpu::Buffer> outputs;
    for (int round = 0; round < 20; ++round) {
        outputs.push_back(make("out", count * 4));
        run_scale(device.create_bind_group(scale, {{in}, {outputs.back()}, {parameters(count, 0.5f)}}), count);
    }
    const std::vector<float> expected = scaled(input, 0.5f);
    for (const gpu::Buffer& out : outputs) {
        EXPECT_TRUE(download<float>(out, count) == expected);
    }
}

TEST_P(LifetimeTest, ADeviceMayCloseWithWorkUnderWay) {
    gpu::Device closing = open_device(GetParam().id);
    gpu::CommandEncoder encoder = closing.create_command_encoder();
    gpu::Buffer last = closing.create_buffer({"last", 32 << 20, gpu::BufferUsage::copy_destination});
    encoder.fill_buffer(last, 0, last.size(), 1);
    closing.queue().submit(encoder.finish());
    encoder = gpu::CommandEncoder();
    closing = gpu::Device();
    last = gpu::Buffer();
}

TESSERA_ON_EVERY_DEVICE(LifetimeTest);

}  // namespace
}  // namespace tessera::backends
