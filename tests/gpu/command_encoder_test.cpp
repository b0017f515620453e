#include "gpu/null_device.hpp"

namespace tessera::gpu {
namespace {

constexpr std::uint64_t huge = ~std::uint64_t{3};  // a multiple of 4 that overflows when added to

class CommandEncoderTest : public NullDeviceTest {
protected:
    void submit() { device.queue().submit(encoder.finish()); }

    CommandEncoder encoder = device.create_command_encoder();
    Buffer a = storage("a");
    Buffer b = storage("b", 512);
};

TEST_F(CommandEncoderTest, RecordsCopiesAndFillsInOrder) {
    encoder.fill_buffer(a, 4, 8, 0xdeadbeef);
    encoder.copy_buffer_to_buffer(a, 12, b, 16, 20);
    submit();
    ASSERT_EQ(log.commands.size(), 2u);
    const auto fill = command<FillBuffer>(0);
    EXPECT_EQ(fill.offset, 4u);
    EXPECT_EQ(fill.size, 8u);
    EXPECT_EQ(fill.value, 0xdeadbeef);
    const auto copy = command<CopyBuffer>(1);
    EXPECT_EQ(copy.source, fill.buffer);
    EXPECT_EQ(copy.source_offset, 12u);
    EXPECT_NE(copy.destination, copy.source);
    EXPECT_EQ(copy.destination_offset, 16u);
    EXPECT_EQ(copy.size, 20u);
}

TEST_F(CommandEncoderTest, DropsEmptyWork) {
    encoder.fill_buffer(a, 1024, 0, 1);
    encoder.copy_buffer_to_buffer(a, 1024, b, 512, 0);
    submit();
    EXPECT_TRUE(log.commands.empty());
}

TEST_F(CommandEncoderTest, RefusesBadCopies) {
    const auto refused = [&](const Buffer& from, std::uint64_t from_offset, const Buffer& to, std::uint64_t to_offset,
                             std::uint64_t size, std::initializer_list<std::string_view> parts) {
        expect_refused([&] { encoder.copy_buffer_to_buffer(from, from_offset, to, to_offset, size); }, parts);
    };
    refused(Buffer(), 0, b, 0, 4, {"copy_buffer_to_buffer", "null"});
    refused(a, 0, Buffer(), 0, 4, {"copy_buffer_to_buffer", "null"});
    refused(a, 2, b, 0, 4, {"'a'", "offset 2", "multiple of 4"});
    refused(a, 0, b, 6, 4, {"'b'", "offset 6", "multiple of 4"});
    refused(a, 0, b, 0, 5, {"'a'", "5 bytes", "multiple of 4"});
    refused(a, 1020, b, 0, 8, {"'a'", "8 bytes", "offset 1020", "1024"});
    refused(a, 0, b, 0, 516, {"'b'", "516 bytes", "512"});
    refused(a, huge, b, 0, 8, {"'a'", "1024"});
    refused(a, 4, b, 0, huge, {"'a'", "1024"});
    refused(a, 0, b, huge, 8, {"'b'", "512"});
    refused(a, 0, a, 512, 4, {"'a'", "source and as destination"});
    refused(uniform("u"), 0, b, 0, 4, {"usage copy_source", "'u'"});
    refused(a, 0, buffer("s", 64, BufferUsage::storage), 0, 4, {"usage copy_destination", "'s'"});
    refused(other_device.create_buffer({"foreign", 64, BufferUsage::copy_source}), 0, b, 0, 4,
            {"'foreign'", "another device"});
    b.destroy();
    refused(a, 0, b, 0, 4, {"'b'", "destroyed"});
    submit();
    EXPECT_TRUE(log.commands.empty());
}

TEST_F(CommandEncoderTest, RefusesBadFills) {
    const auto refused = [&](const Buffer& target, std::uint64_t offset, std::uint64_t size,
                             std::initializer_list<std::string_view> parts) {
        expect_refused([&] { encoder.fill_buffer(target, offset, size, 0); }, parts);
    };
    refused(Buffer(), 0, 4, {"fill_buffer", "null"});
    refused(a, 1, 4, {"'a'", "offset 1", "multiple of 4"});
    refused(a, 0, 3, {"'a'", "3 bytes", "multiple of 4"});
    refused(a, 4, 1024, {"'a'", "1024 bytes", "offset 4"});
    refused(a, huge, 8, {"'a'"});
    refused(a, 8, huge, {"'a'"});
    refused(buffer("s", 64, BufferUsage::storage), 0, 4, {"usage copy_destination", "'s'"});
    a.destroy();
    refused(a, 0, 4, {"'a'", "destroyed"});
}

TEST_F(CommandEncoderTest, RefusesUseAfterFinish) {
    const QuerySet queries = device.create_query_set(2);
    const Buffer times = buffer("times", 16, BufferUsage::query_resolve);
    encoder.finish();
    expect_refused([&] { encoder.begin_compute_pass(); }, {"begin_compute_pass", "after finish"});
    expect_refused([&] { encoder.copy_buffer_to_buffer(a, 0, b, 0, 4); }, {"copy_buffer_to_buffer", "after finish"});
    expect_refused([&] { encoder.fill_buffer(a, 0, 4, 0); }, {"fill_buffer", "after finish"});
    expect_refused([&] { encoder.write_timestamp(queries, 0); }, {"write_timestamp", "after finish"});
    expect_refused([&] { encoder.resolve_query_set(queries, 0, 2, times, 0); }, {"resolve_query_set", "after finish"});
    expect_refused([&] { encoder.finish(); }, {"finish", "after finish"});
    expect_refused([] { CommandEncoder().finish(); }, {"finish", "null"});
}

TEST_F(CommandEncoderTest, RefusesOtherCommandsWhileAPassIsOpen) {
    const QuerySet queries = device.create_query_set(2);
    ComputePass pass = encoder.begin_compute_pass();
    expect_refused([&] { encoder.begin_compute_pass(); }, {"begin_compute_pass", "pass 1", "open"});
    expect_refused([&] { encoder.fill_buffer(a, 0, 4, 0); }, {"fill_buffer", "pass 1", "open"});
    expect_refused([&] { encoder.write_timestamp(queries, 0); }, {"write_timestamp", "pass 1", "open"});
    expect_refused([&] { encoder.finish(); }, {"finish", "pass 1", "open"});
    pass.end();
    EXPECT_NO_THROW(encoder.finish());
}

}  // namespace
}  // namespace tessera::gpu
