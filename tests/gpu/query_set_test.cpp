#include "gpu/null_device.hpp"

namespace tessera::gpu {
namespace {

class QuerySetTest : public NullDeviceTest {
protected:
    QuerySet queries = device.create_query_set(4);
    Buffer times = buffer("times", 64, BufferUsage::query_resolve);
    CommandEncoder encoder = device.create_command_encoder();
};

TEST_F(QuerySetTest, RecordsTimestamps) {
    encoder.write_timestamp(queries, 1);
    encoder.write_timestamp(queries, 2);
    encoder.resolve_query_set(queries, 1, 2, times, 48);
    device.queue().submit(encoder.finish());
    ASSERT_EQ(log.commands.size(), 3u);
    EXPECT_EQ(command<WriteTimestamp>(0).index, 1u);
    EXPECT_EQ(command<WriteTimestamp>(1).index, 2u);
    const auto resolve = command<ResolveQuerySet>(2);
    EXPECT_EQ(resolve.query_set, command<WriteTimestamp>(0).query_set);
    EXPECT_EQ(resolve.first, 1u);
    EXPECT_EQ(resolve.count, 2u);
    EXPECT_EQ(resolve.offset, 48u);
}

TEST_F(QuerySetTest, NeedsADeviceWithTimestamps) {
    DeviceInfo info = null_info();
    info.timestamps = false;
    NullLog timeless_log;
    Device timeless(std::make_unique<NullBackend>(timeless_log, info));
    expect_refused([&] { timeless.create_query_set(4); }, {"create_query_set", "timestamps", "null:0", "no device"});
    expect_refused([] { Device().create_query_set(4); }, {"create_query_set", "null"});
}

TEST_F(QuerySetTest, RefusesBadCounts) {
    expect_refused([&] { device.create_query_set(0); }, {"count of 0", "4096"});
    expect_refused([&] { device.create_query_set(4097); }, {"count of 4097", "4096"});
    EXPECT_NO_THROW(device.create_query_set(4096));
}

TEST_F(QuerySetTest, RefusesBadWrites) {
    expect_refused([&] { encoder.write_timestamp(queries, 4); }, {"index 4", "4 timestamps"});
    expect_refused([&] { encoder.write_timestamp(QuerySet(), 0); }, {"write_timestamp", "null"});
    const QuerySet foreign = other_device.create_query_set(3);
    expect_refused([&] { encoder.write_timestamp(foreign, 0); }, {"write_timestamp", "3", "another device"});
}

TEST_F(QuerySetTest, RefusesBadResolves) {
    const auto refused = [&](std::uint32_t first, std::uint32_t count, const Buffer& target, std::uint64_t offset,
                             std::initializer_list<std::string_view> parts) {
        expect_refused([&] { encoder.resolve_query_set(queries, first, count, target, offset); }, parts);
    };
    refused(0, 5, times, 0, {"5 timestamps", "index 0", "of 4"});
    refused(5, 0, times, 0, {"index 5", "of 4"});
    refused(2, 0xffffffff, times, 0, {"index 2", "of 4"});
    refused(0, 2, times, 4, {"'times'", "offset 4", "multiple of 8"});
    refused(0, 2, times, 56, {"'times'", "16 bytes", "offset 56", "64"});
    refused(0, 2, storage("plain"), 0, {"usage query_resolve", "'plain'"});
    refused(0, 2, Buffer(), 0, {"resolve_query_set", "null"});
    expect_refused([&] { encoder.resolve_query_set(QuerySet(), 0, 1, times, 0); }, {"resolve_query_set", "null"});
}

TEST_F(QuerySetTest, DropsEmptyResolves) {
    encoder.resolve_query_set(queries, 4, 0, times, 64);
    device.queue().submit(encoder.finish());
    EXPECT_TRUE(log.commands.empty());
}

TEST_F(QuerySetTest, RefusesToResolveWhatNobodyWrote) {
    encoder.write_timestamp(queries, 0);
    encoder.resolve_query_set(queries, 0, 2, times, 0);
    const CommandBuffer unwritten = encoder.finish();
    expect_refused([&] { device.queue().submit(unwritten); }, {"timestamp 1", "query set of 4"});

    CommandEncoder late = device.create_command_encoder();
    late.resolve_query_set(queries, 0, 1, times, 0);
    late.write_timestamp(queries, 0);
    expect_refused([&] { device.queue().submit(late.finish()); }, {"timestamp 0"});
    EXPECT_TRUE(log.commands.empty());
}

TEST_F(QuerySetTest, ResolvesWhatAnEarlierSubmitWrote) {
    CommandEncoder resolver = device.create_command_encoder();
    resolver.resolve_query_set(queries, 3, 1, times, 0);
    const CommandBuffer resolve = resolver.finish();
    encoder.write_timestamp(queries, 3);
    const CommandBuffer write = encoder.finish();
    expect_refused([&] { device.queue().submit(resolve); }, {"timestamp 3"});
    device.queue().submit(write);
    EXPECT_NO_THROW(device.queue().submit(resolve)) << "a refused submit can be tried again";
    EXPECT_EQ(log.commands.size(), 2u);
}

}  // namespace
}  // namespace tessera::gpu
