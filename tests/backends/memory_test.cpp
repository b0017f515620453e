// Buffers: what is written, copied and filled is read back, and nothing beside it changes.
#include "backends/device_suite.hpp"

#include <numeric>

namespace tessera::backends {
namespace {

using Words = std::vector<std::uint32_t>;

Words counting(std::size_t count) {
    Words words(count);
    std::iota(words.begin(), words.end(), 1u);
    return words;
}

using MemoryTest = DeviceTest;

TEST_P(MemoryTest, NewBuffersHoldZeros) {
    // Dirty memory first, so that a device which hands it out again is seen.
    for (int round = 0; round < 4; ++round) {
        const gpu::Buffer fresh = make("fresh", 1 << 20);
        EXPECT_EQ(download<std::uint32_t>(fresh, 1 << 18), Words(1 << 18, 0u)) << "round " << round;
        write(fresh, Words(1 << 18, sentinel));
    }
}

TEST_P(MemoryTest, ReadsBackWhatWasWritten) {
    const gpu::Buffer buffer = upload("buffer", Words(100, sentinel));
    write(buffer, counting(10), 4);
    write(buffer, Words{7}, 396);
    Words expected(100, sentinel);
    std::iota(expected.begin() + 1, expected.begin() + 11, 1u);
    expected[99] = 7;
    EXPECT_EQ(download<std::uint32_t>(buffer, 100), expected);
    EXPECT_EQ(download<std::uint32_t>(buffer, 3, 36), (Words{9, 10, sentinel}));
}

TEST_P(MemoryTest, CopiesOnlyTheRange) {
    const gpu::Buffer source = upload("source", counting(64));
    const gpu::Buffer destination = upload("destination", Words(64, sentinel));
    gpu::CommandEncoder encoder = device.create_command_encoder();
    encoder.copy_buffer_to_buffer(source, 12, destination, 20, 40);
    queue.submit(encoder.finish());
    Words expected(64, sentinel);
    std::iota(expected.begin() + 5, expected.begin() + 15, 4u);
    EXPECT_EQ(download<std::uint32_t>(destination, 64), expected);
    EXPECT_EQ(download<std::uint32_t>(source, 64), counting(64));
}

TEST_P(MemoryTest, FillsOnlyTheRange) {
    const gpu::Buffer buffer = upload("buffer", Words(64, sentinel));
    gpu::CommandEncoder encoder = device.create_command_encoder();
    encoder.fill_buffer(buffer, 4, 12, 0x01020304);
    encoder.fill_buffer(buffer, 252, 4, 0);
    queue.submit(encoder.finish());
    Words expected(64, sentinel);
    std::fill_n(expected.begin() + 1, 3, 0x01020304u);
    expected[63] = 0;
    EXPECT_EQ(download<std::uint32_t>(buffer, 64), expected);
}

TEST_P(MemoryTest, WritesMoreThanAnyStagingBlock) {
    const Words words = counting((24 << 20) / 4 + 3);
    const gpu::Buffer buffer = upload("long", words);
    EXPECT_TRUE(download<std::uint32_t>(buffer, words.size()) == words);
}

TEST_P(MemoryTest, BindsTheLargestStorageBindingOfWebGpu) {
    constexpr std::uint64_t size = 128ull << 20;
    constexpr std::uint32_t count = size / sizeof(float);
    const gpu::Buffer in = make("in", size);
    const gpu::Buffer out = make("out", size);
    const gpu::BindGroup group = device.create_bind_group(scale, {{in}, {out}, {parameters(count, 3.0f)}});
    gpu::CommandEncoder encoder = device.create_command_encoder();
    encoder.fill_buffer(in, 0, size, std::bit_cast<std::uint32_t>(2.0f));
    encoder.fill_buffer(in, size - 4, 4, std::bit_cast<std::uint32_t>(5.0f));
    gpu::ComputePass pass = encoder.begin_compute_pass();
    pass.set_pipeline(scale);
    pass.set_bind_group(group);
    pass.dispatch_workgroups(32768, count / 32768 / gpu::workgroup_size);
    pass.end();
    queue.submit(encoder.finish());
    const std::vector<float> result = download<float>(out, count);
    EXPECT_EQ(result.back(), 16.0f);
    EXPECT_TRUE(std::all_of(result.begin(), result.end() - 1, [](float value) { return value == 7.0f; }));
}

TESSERA_ON_EVERY_DEVICE(MemoryTest);

}  // namespace
}  // namespace tessera::backends
