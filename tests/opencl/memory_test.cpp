// Buffers: zeroed, written in order, bound by ranges, and alive for as long as the queue needs them.
#include "opencl/opencl_fixture.hpp"

#include "backends/opencl/opencl_submit.hpp"
#include "base/error.hpp"

#include <numeric>

namespace tessera::test {
namespace {

using backends::opencl::max_staged_write;

TEST_F(OpenClTest, NewBuffersAreZero) {
    for (int round = 0; round < 3; ++round) {  // later rounds meet memory that was used before
        const Object made = buffer(1u << 20);
        const auto values = read<std::uint32_t>(made, 1u << 18);
        ASSERT_EQ(std::count(values.begin(), values.end(), 0u), 1 << 18);
        submit({gpu::FillBuffer{made.get(), 0, 1u << 20, 0xffffffffu}});
        device->wait();
    }
}

// The way of devices with memory of their own, taken here on whatever device there is.
TEST_F(OpenClTest, NewBuffersOfDeviceMemoryAreZero) {
    using namespace backends::opencl;
    Findings findings = find_devices();
    findings.devices[0].info.software = false;
    const Session session = open_session(*findings.api, findings.devices[0]);
    Staging staging;
    for (int round = 0; round < 3; ++round) {
        BufferObject made(session, {"test", 1u << 20, gpu::BufferUsage::storage});
        std::vector<std::uint32_t> values(1u << 18);
        read_now(session, staging, made, 0, std::as_writable_bytes(std::span(values)));
        ASSERT_EQ(std::count(values.begin(), values.end(), 0u), 1 << 18);
        std::fill(values.begin(), values.end(), 0xffffffffu);
        enqueue_write(session, staging, made, 0, std::as_bytes(std::span(values)));
    }
}

TEST_F(OpenClTest, WritesOfEverySizeArriveInOrder) {
    const Object target = buffer(4u << 20);
    std::vector<std::uint32_t> expected(1u << 20);
    std::uint32_t next = 1;
    // More than the staging holds in small writes, with large ones between, overlapping.
    for (std::size_t i = 0; i < 200; ++i) {
        const std::size_t words = i % 100 == 99 ? max_staged_write / 4 + 1 : 1 + (i * 977) % (max_staged_write / 4);
        const std::size_t first = (i * 4001) % (expected.size() - words);
        std::vector<std::uint32_t> data(words);
        std::iota(data.begin(), data.end(), next);
        next += static_cast<std::uint32_t>(words);
        std::copy(data.begin(), data.end(), expected.begin() + static_cast<std::ptrdiff_t>(first));
        write(target, first * 4, data);
    }
    EXPECT_EQ(read<std::uint32_t>(target, expected.size()), expected);
}

TEST_F(OpenClTest, CopiesAndFillsObeyTheirRanges) {
    std::vector<std::uint32_t> values(256);
    std::iota(values.begin(), values.end(), 0u);
    const Object a = buffer_of(values), b = buffer(1024);
    submit({gpu::FillBuffer{b.get(), 8, 16, 0xabcdef01u}, gpu::CopyBuffer{a.get(), 40, b.get(), 12, 4},
            gpu::CopyBuffer{a.get(), 0, b.get(), 0, 0}, gpu::FillBuffer{b.get(), 0, 0, 1u}});
    EXPECT_EQ(read<std::uint32_t>(b, 7),
              (std::vector<std::uint32_t>{0, 0, 0xabcdef01u, 10, 0xabcdef01u, 0xabcdef01u, 0}));
    EXPECT_EQ(read<std::uint32_t>(a, 2, 1016), (std::vector<std::uint32_t>{254, 255}));
}

TEST_F(OpenClTest, BoundRangesAndUniformOffsetsAreObeyed) {
    const std::uint64_t step = device->info().limits.storage_offset_alignment;
    const std::size_t words = step / 4;
    std::vector<float> in(4 * words);
    std::iota(in.begin(), in.end(), 0.0f);
    const Object from = buffer_of(in), to = buffer(4 * step), uniforms = buffer(4 * step);
    for (std::uint32_t i = 0; i < 4; ++i) {
        write(uniforms, i * step, std::vector<ScaleParams>{{16, 10.0f * static_cast<float>(i)}});
    }
    const Object pipeline = device->create_pipeline(scale_kernel());
    // Reads from the third step, writes to the second; uniforms count from the second.
    const Object group =
        bind(pipeline, {{from.get(), 2 * step, step}, {to.get(), step, step}, {uniforms.get(), step, 8}});
    for (const std::uint32_t at : {0u, 2u, 1u, 0u}) {
        submit({gpu::FillBuffer{to.get(), 0, 4 * step, 0xbf800000u},
                gpu::Dispatch{pipeline.get(), group.get(), static_cast<std::uint32_t>(at * step), 1, 1}});
        std::vector<float> expected(4 * words, -1.0f);
        for (std::size_t i = 0; i < 16; ++i) {
            expected[words + i] = in[2 * words + i] * (10.0f * static_cast<float>(at + 1)) + 1.0f;
        }
        ASSERT_EQ(read<float>(to, expected.size()), expected) << "uniform offset " << at << " steps";
    }
    // The last struct of the buffer: the range may not reach beyond the end.
    const Object last = bind(pipeline, {{from.get(), 0, step}, {to.get(), 0, 4 * step}, {uniforms.get(), 0, 4 * step}});
    submit({gpu::Dispatch{pipeline.get(), last.get(), static_cast<std::uint32_t>(3 * step), 1, 1}});
    EXPECT_EQ(read<float>(to, 3), (std::vector<float>{1.0f, 31.0f, 61.0f}));
}

TEST_F(OpenClTest, BuffersMayGoBeforeTheirWorkIsDone) {
    constexpr std::uint32_t groups = 4096, count = groups * 64;
    const Object result = buffer(4 * count);
    const Object pipeline = device->create_pipeline(scale_kernel());
    {
        const Object from = buffer_of(std::vector<float>(count, 3.0f)), between = buffer(4 * count);
        const Object uniforms = buffer_of(std::vector<ScaleParams>{{count, 2.0f}});
        const Object group =
            bind(pipeline, {{from.get(), 0, 4 * count}, {between.get(), 0, 4 * count}, {uniforms.get(), 0, 8}});
        const Object ranged =
            bind(pipeline, {{between.get(), 0, 2 * count}, {result.get(), 0, 4 * count}, {uniforms.get(), 0, 8}});
        std::vector<gpu::Command> commands(50, gpu::Dispatch{pipeline.get(), group.get(), 0, groups, 1});
        commands.push_back(gpu::Dispatch{pipeline.get(), ranged.get(), 0, groups / 2, 1});
        commands.push_back(gpu::CopyBuffer{between.get(), 2 * count, result.get(), 2 * count, 2 * count});
        submit(commands);
    }
    const std::vector<float> out = read<float>(result, count);
    EXPECT_EQ(std::count(out.begin(), out.begin() + count / 2, 15.0f), count / 2);
    EXPECT_EQ(std::count(out.begin() + count / 2, out.end(), 7.0f), count / 2);
}

TEST_F(OpenClTest, ABufferThatIsTooLargeIsRefusedByName) {
    try {
        buffer(1ull << 46, "huge");
        FAIL() << "made a buffer of 64 TiB";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::device_unavailable);
        EXPECT_NE(std::string(error.what()).find("\"huge\" of 70368744177664 bytes"), std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace tessera::test
