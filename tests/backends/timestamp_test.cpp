#include "backends/device_suite.hpp"

namespace tessera::backends {
namespace {

using TimestampTest = DeviceTest;

TEST_P(TimestampTest, NeverRunBackwards) {
    if (!device.info().timestamps) {
        GTEST_SKIP() << device.info().id << " has no timestamps";
    }
    constexpr std::uint32_t count = 500'000;
    constexpr std::uint32_t stamps = 5;
    const gpu::BindGroup group = device.create_bind_group(
        scale, {{upload("in", noise(count))}, {make("out", count * 4)}, {parameters(count, 0.5f)}});
    const gpu::QuerySet queries = device.create_query_set(stamps + 2);
    const gpu::Buffer times = make("times", 64, gpu::BufferUsage::query_resolve);
    for (int round = 0; round < 3; ++round) {  // a query is written anew by every submit
        write(times, std::vector<std::uint32_t>(16, sentinel));
        gpu::CommandEncoder encoder = device.create_command_encoder();
        for (std::uint32_t i = 0; i < stamps; ++i) {
            encoder.write_timestamp(queries, i + 1);
            record_scale(encoder, group, count);
        }
        encoder.resolve_query_set(queries, 1, stamps, times, 8);
        queue.submit(encoder.finish());
        const auto values = download<std::uint64_t>(times, 8);
        const std::uint64_t untouched = std::uint64_t{sentinel} << 32 | sentinel;
        EXPECT_EQ(values[0], untouched);
        EXPECT_EQ(values[6], untouched);
        EXPECT_TRUE(std::is_sorted(values.begin() + 1, values.begin() + 6));
        EXPECT_LT(values[1], values[5]) << "four dispatches take time";
        EXPECT_LT(values[5] - values[1], 60'000'000'000u) << "the unit is nanoseconds";
    }
}

TEST_P(TimestampTest, ResolveWhatAnEarlierSubmitWrote) {
    if (!device.info().timestamps) {
        GTEST_SKIP() << device.info().id << " has no timestamps";
    }
    const gpu::QuerySet queries = device.create_query_set(2);
    const gpu::Buffer times = make("times", 16, gpu::BufferUsage::query_resolve);
    for (std::uint32_t i = 0; i < 2; ++i) {
        gpu::CommandEncoder encoder = device.create_command_encoder();
        encoder.write_timestamp(queries, i);
        queue.submit(encoder.finish());
    }
    gpu::CommandEncoder encoder = device.create_command_encoder();
    encoder.resolve_query_set(queries, 0, 2, times, 0);
    queue.submit(encoder.finish());
    const auto values = download<std::uint64_t>(times, 2);
    EXPECT_GT(values[0], 0u);
    EXPECT_LE(values[0], values[1]);
}

TESSERA_ON_EVERY_DEVICE(TimestampTest);

}  // namespace
}  // namespace tessera::backends
