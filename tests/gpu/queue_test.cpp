#include "gpu/null_device.hpp"

#include <array>

namespace tessera::gpu {
namespace {

class QueueTest : public NullDeviceTest {
protected:
    Queue queue = device.queue();
    Buffer a = storage("a", 64);
    std::array<std::byte, 128> bytes{};
    std::span<std::byte> some(std::size_t size) { return std::span(bytes).first(size); }
};

TEST_F(QueueTest, PassesReadsAndWritesOn) {
    log.calls.clear();
    queue.write_buffer(a, 8, some(16));
    queue.read_buffer(a, 4, some(60));
    queue.wait();
    EXPECT_EQ(log.calls, (std::vector<std::string>{"write 8 16", "read 4 60", "wait"}));
}

TEST_F(QueueTest, EmptyWritesDoNothingAndEmptyReadsWait) {
    log.calls.clear();
    queue.write_buffer(a, 64, {});
    queue.read_buffer(a, 0, {});
    EXPECT_EQ(log.calls, std::vector<std::string>{"wait"});
}

TEST_F(QueueTest, RefusesBadReadsAndWrites) {
    const auto both = [&](const Buffer& target, std::uint64_t offset, std::size_t size,
                          std::initializer_list<std::string_view> parts) {
        expect_refused([&] { queue.write_buffer(target, offset, some(size)); }, parts);
        expect_refused([&] { queue.read_buffer(target, offset, some(size)); }, parts);
    };
    log.calls.clear();
    both(Buffer(), 0, 4, {"_buffer", "null"});
    both(a, 2, 4, {"'a'", "offset 2", "multiple of 4"});
    both(a, 0, 7, {"'a'", "7 bytes", "multiple of 4"});
    both(a, 0, 68, {"'a'", "68 bytes", "64"});
    both(a, 60, 8, {"'a'", "8 bytes", "offset 60"});
    both(a, ~std::uint64_t{3}, 8, {"'a'", "8 bytes"});
    both(other_device.create_buffer({"foreign", 64, BufferUsage::copy_source | BufferUsage::copy_destination}), 0, 4,
         {"'foreign'", "another device"});
    a.destroy();
    both(a, 0, 4, {"'a'", "destroyed"});
    EXPECT_TRUE(log.calls.empty());
    const Buffer plain = buffer("plain", 64, BufferUsage::storage);
    expect_refused([&] { queue.write_buffer(plain, 0, some(4)); }, {"usage copy_destination", "'plain'"});
    expect_refused([&] { queue.read_buffer(plain, 0, some(4)); }, {"usage copy_source", "'plain'"});
}

TEST_F(QueueTest, RefusesNullHandles) {
    expect_refused([&] { Queue().write_buffer(a, 0, some(4)); }, {"write_buffer", "null"});
    expect_refused([&] { Queue().read_buffer(a, 0, some(4)); }, {"read_buffer", "null"});
    expect_refused([] { Queue().wait(); }, {"wait", "null"});
    expect_refused([&] { queue.submit(CommandBuffer()); }, {"submit", "null"});
    expect_refused([] { Queue().submit(CommandBuffer()); }, {"submit", "null"});
}

TEST_F(QueueTest, SubmitsOnce) {
    CommandEncoder encoder = device.create_command_encoder();
    encoder.fill_buffer(a, 0, 4, 1);
    const CommandBuffer commands = encoder.finish();
    queue.submit(commands);
    expect_refused([&] { queue.submit(commands); }, {"submit", "submitted before"});
    EXPECT_EQ(log.commands.size(), 1u);
}

TEST_F(QueueTest, RefusesCommandsOfAnotherDevice) {
    const CommandBuffer commands = other_device.create_command_encoder().finish();
    expect_refused([&] { queue.submit(commands); }, {"submit", "another device"});
}

}  // namespace
}  // namespace tessera::gpu
