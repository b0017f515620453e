// What the backend computes and copies, and that every command sees the ones before it.
#include <cstring>
#include <numeric>

#include "vulkan/each_device.hpp"

namespace tessera::test {
namespace {

using gpu::BufferUsage;

std::vector<float> ramp(std::size_t count) {
    std::vector<float> values(count);
    std::iota(values.begin(), values.end(), 0.0f);
    return values;
}

TEST(VulkanCompute, RunsAKernel) {
    each_device([](Opened& on) {
        const gpu::Buffer source = make_buffer(on.device, "source", ramp(1000));
        const gpu::Buffer result = make_buffer(on.device, "result", std::vector<float>(1024, -7.0f));
        const Scale scale(on.device, source, result, 1000, 0.5f);
        gpu::CommandEncoder encoder = on.device.create_command_encoder();
        scale.record(encoder);
        on.device.queue().submit(encoder.finish());
        const auto values = content_of<float>(on.device, result);
        for (std::size_t i = 0; i < values.size(); ++i) {
            ASSERT_EQ(values[i], i < 1000 ? 0.5f * static_cast<float>(i) + 1.0f : -7.0f) << i;
        }
    });
}

TEST(VulkanCompute, EachDispatchSeesTheOnesBefore) {
    each_device([](Opened& on) {
        // x -> 2x+1, from one buffer to the other and back: write after read and read after write, 200 times, within
        // and across submissions.
        const gpu::Buffer a = make_buffer(on.device, "a", std::vector<float>(4096, 1.0f));
        const gpu::Buffer b = make_buffer(on.device, "b", std::vector<float>(4096, 0.0f));
        const Scale there(on.device, a, b, 4096, 0.5f), back(on.device, b, a, 4096, 2.0f);
        const auto before = on.counters();
        for (int submission = 0; submission < 20; ++submission) {
            gpu::CommandEncoder encoder = on.device.create_command_encoder();
            for (int i = 0; i < 10; ++i) {
                there.record(encoder);
                back.record(encoder);
            }
            on.device.queue().submit(encoder.finish());
        }
        // x/2 + 1, then 2x + 1: three more each time.
        EXPECT_EQ(content_of<float>(on.device, a), std::vector<float>(4096, 1.0f + 3.0f * 200));
        EXPECT_GE(on.counters().barriers - before.barriers, 399u);
    });
}

TEST(VulkanCompute, IndependentDispatchesNeedNoBarrier) {
    each_device([](Opened& on) {
        const gpu::Buffer source = make_buffer(on.device, "source", ramp(256));
        std::vector<gpu::Buffer> results;
        std::vector<Scale> scales;
        for (int i = 0; i < 10; ++i) {
            results.push_back(
                on.device.create_buffer({"result", 1024, BufferUsage::storage | BufferUsage::copy_source}));
            scales.emplace_back(on.device, source, results.back(), 256, static_cast<float>(i));
        }
        on.device.queue().wait();
        const auto before = on.counters();
        gpu::CommandEncoder encoder = on.device.create_command_encoder();
        for (const Scale& scale : scales)
            scale.record(encoder);
        on.device.queue().submit(encoder.finish());
        // One at most: staged uploads must be seen.
        EXPECT_LE(on.counters().barriers - before.barriers, 1u);
        for (int i = 0; i < 10; ++i) {
            EXPECT_EQ(content_of<float>(on.device, results[i])[255], 255.0f * static_cast<float>(i) + 1.0f);
        }
    });
}

TEST(VulkanCompute, IndirectCountsComeFromEarlierCommands) {
    each_device([](Opened& on) {
        const gpu::Buffer source = make_buffer(on.device, "source", ramp(256));
        const gpu::Buffer result = make_buffer(on.device, "result", std::vector<float>(256, 0.0f));
        const gpu::Buffer arguments =
            make_buffer<std::uint32_t>(on.device, "arguments", {9, 1, 1}, BufferUsage::indirect);
        const Scale scale(on.device, source, result, 256, 1.0f);
        gpu::CommandEncoder encoder = on.device.create_command_encoder();
        encoder.fill_buffer(arguments, 0, 4, 2);
        scale.record_indirect(encoder, arguments);
        encoder.fill_buffer(arguments, 0, 4, 7);  // must wait until the arguments have been read
        on.device.queue().submit(encoder.finish());
        const auto values = content_of<float>(on.device, result);
        EXPECT_EQ(values[127], 128.0f);
        EXPECT_EQ(values[128], 0.0f);
        EXPECT_EQ(content_of<std::uint32_t>(on.device, arguments)[0], 7u);
    });
}

TEST(VulkanCompute, UniformOffsetsChooseTheParameters) {
    each_device([](Opened& on) {
        const std::uint32_t step = on.device.limits().uniform_offset_alignment;
        std::vector<std::byte> bytes(step + sizeof(ScaleParameters));
        const ScaleParameters first{64, 2.0f}, second{64, 3.0f};
        std::memcpy(bytes.data(), &first, sizeof first);
        std::memcpy(bytes.data() + step, &second, sizeof second);
        const gpu::Buffer parameters = make_buffer(on.device, "parameters", bytes, BufferUsage::uniform);
        const gpu::Buffer source = make_buffer(on.device, "source", ramp(64));
        const gpu::Buffer result = make_buffer(on.device, "result", std::vector<float>(64, 0.0f));
        const auto pipeline = on.device.create_compute_pipeline(gpu::find_kernel("scale_probe"));
        const auto group = on.device.create_bind_group(pipeline, {{source}, {result}, {parameters}});
        for (const std::uint32_t offset : {step, 0u}) {
            gpu::CommandEncoder encoder = on.device.create_command_encoder();
            gpu::ComputePass pass = encoder.begin_compute_pass();
            pass.set_pipeline(pipeline);
            pass.set_bind_group(group, offset);
            pass.dispatch_workgroups(1);
            pass.end();
            on.device.queue().submit(encoder.finish());
            EXPECT_EQ(content_of<float>(on.device, result)[10], offset == 0 ? 21.0f : 31.0f);
        }
    });
}

TEST(VulkanCompute, WritesAreOrderedWithSubmissions) {
    each_device([](Opened& on) {
        constexpr std::size_t count = 1u << 18;
        const gpu::Buffer source = make_buffer(on.device, "source", std::vector<std::uint32_t>(count, 1));
        const gpu::Buffer old = make_buffer(on.device, "old", std::vector<std::uint32_t>(count, 0));
        const gpu::Buffer now = make_buffer(on.device, "now", std::vector<std::uint32_t>(count, 0));
        const std::vector<std::uint32_t> twos(count, 2);
        const auto copy_to = [&](const gpu::Buffer& destination) {
            gpu::CommandEncoder encoder = on.device.create_command_encoder();
            encoder.copy_buffer_to_buffer(source, 0, destination, 0, count * 4);
            on.device.queue().submit(encoder.finish());
        };
        copy_to(old);
        on.device.queue().write_buffer(source, 0, std::as_bytes(std::span(twos)));
        copy_to(now);
        EXPECT_EQ(content_of<std::uint32_t>(on.device, old), std::vector<std::uint32_t>(count, 1));
        EXPECT_EQ(content_of<std::uint32_t>(on.device, now), twos);
    });
}

TEST(VulkanCompute, DataLargerThanTheStagingRingArrives) {
    each_device([](Opened& on) {
        std::vector<std::uint32_t> values((21u << 20) / 4 + 3);
        std::iota(values.begin(), values.end(), 5u);
        const gpu::Buffer buffer = make_buffer(on.device, "large", values);
        EXPECT_EQ(content_of<std::uint32_t>(on.device, buffer), values);
        values[1] = 77;  // a small write at an odd place, after a large one
        on.device.queue().write_buffer(buffer, 4, std::as_bytes(std::span(values)).subspan(4, 4));
        EXPECT_EQ(content_of<std::uint32_t>(on.device, buffer), values);
    });
}

TEST(VulkanCompute, TimestampsDoNotGoBack) {
    each_device([](Opened& on) {
        ASSERT_TRUE(on.device.info().timestamps);
        const gpu::Buffer a = make_buffer(on.device, "a", ramp(1u << 16));
        const gpu::Buffer b = make_buffer(on.device, "b", ramp(1u << 16));
        const gpu::Buffer times =
            on.device.create_buffer({"times", 24, BufferUsage::query_resolve | BufferUsage::copy_source});
        const gpu::QuerySet queries = on.device.create_query_set(3);
        const Scale scale(on.device, a, b, 1u << 16, 2.0f);
        for (int round = 0; round < 2; ++round) {  // a query may be written again
            gpu::CommandEncoder encoder = on.device.create_command_encoder();
            encoder.write_timestamp(queries, 0);
            scale.record(encoder);
            encoder.write_timestamp(queries, 1);
            encoder.write_timestamp(queries, 2);
            encoder.resolve_query_set(queries, 0, 3, times, 0);
            scale.record(encoder);
            on.device.queue().submit(encoder.finish());
            const auto values = content_of<std::uint64_t>(on.device, times);
            EXPECT_GT(values[0], 0u);
            EXPECT_LE(values[0], values[1]);
            EXPECT_LE(values[1], values[2]);
        }
    });
}

}  // namespace
}  // namespace tessera::test
