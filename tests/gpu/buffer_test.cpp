#include "gpu/null_device.hpp"

namespace tessera::gpu {
namespace {

using BufferTest = NullDeviceTest;

TEST_F(BufferTest, TellsSizeAndLabel) {
    const Buffer made = buffer("factors", 64, BufferUsage::storage);
    EXPECT_TRUE(made);
    EXPECT_EQ(made.size(), 64u);
    EXPECT_EQ(made.label(), "factors");
    EXPECT_EQ(log.calls, std::vector<std::string>{"buffer factors 64"});
}

TEST_F(BufferTest, RefusesNullHandlesAndDevices) {
    const Buffer null;
    EXPECT_FALSE(null);
    expect_refused([&] { null.size(); }, {"Buffer::size", "null"});
    expect_refused([&] { null.label(); }, {"Buffer::label", "null"});
    expect_refused([] { Buffer().destroy(); }, {"Buffer::destroy", "null"});
    expect_refused([] { Device(nullptr); }, {"Device", "null"});
    expect_refused([] { Device().info(); }, {"Device::info", "null"});
    expect_refused([] { Device().queue(); }, {"Device::queue", "null"});
    expect_refused([] { Device().create_command_encoder(); }, {"create_command_encoder", "null"});
    expect_refused([] { Device().create_buffer({"x", 4, BufferUsage::storage}); }, {"create_buffer", "null"});
}

TEST_F(BufferTest, RefusesBadSizes) {
    expect_refused([&] { storage("empty", 0); }, {"'empty'", "0 bytes"});
    expect_refused([&] { storage("odd", 6); }, {"'odd'", "6 bytes", "multiple of 4"});
    expect_refused([&] { storage("big", 8196); }, {"'big'", "8196", "8192"});
    EXPECT_NO_THROW(storage("largest", 8192));
    EXPECT_NO_THROW(storage("smallest", 4));
}

TEST_F(BufferTest, RefusesUnknownAndMissingUsage) {
    expect_refused([&] { buffer("idle", 4, BufferUsage::none); }, {"'idle'", "usage 0x0"});
    expect_refused([&] { buffer("strange", 4, static_cast<BufferUsage>(0x81)); }, {"'strange'", "usage 0x81"});
}

TEST_F(BufferTest, DestroyFreesAtOnceAndTwiceIsFine) {
    Buffer made = storage("a");
    const Buffer copy = made;
    EXPECT_EQ(log.objects, 1);
    made.destroy();
    EXPECT_EQ(log.objects, 0);
    made.destroy();
    EXPECT_EQ(copy.size(), 1024u);
}

}  // namespace
}  // namespace tessera::gpu
