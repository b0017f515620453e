// Animated PNG, read back chunk by chunk.
#include "image/apng.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace tessera::image {
namespace {

struct Chunk {
    std::string type, data;
};

std::uint32_t number(const std::string& bytes, std::size_t at, std::size_t width = 4) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < width; ++i)
        value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
    return value;
}

std::string bytes_of(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(value >> shift & 255u);
    return bytes;
}

std::uint32_t checksum(const std::string& bytes) {
    return static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

/// Fails where a length or a checksum is wrong.
std::vector<Chunk> read_chunks(const std::string& png) {
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    std::vector<Chunk> chunks;
    std::size_t at = 8;
    while (at < png.size()) {
        const std::uint32_t length = number(png, at);
        chunks.push_back({png.substr(at + 4, 4), png.substr(at + 8, length)});
        EXPECT_EQ(number(png, at + 8 + length), checksum(chunks.back().type + chunks.back().data));
        at += 12 + length;
    }
    EXPECT_EQ(at, png.size());
    return chunks;
}

/// A PNG of the header and one frame's data.
Image decode_frame(const std::string& header, const std::string& data) {
    std::string png = "\x89PNG\r\n\x1a\n";
    for (const Chunk& chunk : {Chunk{"IHDR", header}, Chunk{"IDAT", data}, Chunk{"IEND", ""}}) {
        png += bytes_of(static_cast<std::uint32_t>(chunk.data.size())) + chunk.type + chunk.data;
        png += bytes_of(checksum(chunk.type + chunk.data));
    }
    return decode(std::as_bytes(std::span(png)), "frame");
}

Image frame(std::uint32_t number, std::uint32_t width = 7, std::uint32_t height = 5) {
    Image image{width, height, {}};
    for (std::uint32_t i = 0; i < width * height * 4; ++i)
        image.rgba.push_back(static_cast<std::uint8_t>(i * 37 + number * 91));
    return image;
}

class Apng : public testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (std::filesystem::temp_directory_path() / "tessera-apng-XXXXXX").string();
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        folder = pattern;
        path = folder / "moving.apng";
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::string written() const {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    std::filesystem::path folder, path;
};

TEST_F(Apng, HoldsEveryFrame) {
    constexpr std::uint32_t count = 4;
    ApngWriter writer(path, 7, 5, count, 30);
    for (std::uint32_t i = 0; i < count; ++i)
        writer.add(frame(i));
    EXPECT_FALSE(std::filesystem::exists(path)) << "only whole files have names";
    writer.publish();

    const std::vector<Chunk> chunks = read_chunks(written());
    ASSERT_GE(chunks.size(), 5u);
    EXPECT_EQ(chunks[0].type, "IHDR");
    EXPECT_EQ(number(chunks[0].data, 0), 7u);
    EXPECT_EQ(number(chunks[0].data, 4), 5u);
    EXPECT_EQ(chunks[1].type, "acTL");
    EXPECT_EQ(number(chunks[1].data, 0), count);
    EXPECT_EQ(number(chunks[1].data, 4), 0u);
    EXPECT_EQ(chunks.back().type, "IEND");

    std::uint32_t sequence = 0;
    std::vector<std::string> frames;
    for (std::size_t i = 2; i + 1 < chunks.size(); ++i) {
        const Chunk& chunk = chunks[i];
        if (chunk.type == "fcTL") {
            ASSERT_EQ(chunk.data.size(), 26u);
            EXPECT_EQ(number(chunk.data, 0), sequence++);
            EXPECT_EQ(number(chunk.data, 4), 7u);
            EXPECT_EQ(number(chunk.data, 8), 5u);
            EXPECT_EQ(number(chunk.data, 12), 0u);
            EXPECT_EQ(number(chunk.data, 16), 0u);
            EXPECT_EQ(number(chunk.data, 20, 2), 1u);
            EXPECT_EQ(number(chunk.data, 22, 2), 30u);
            EXPECT_EQ(number(chunk.data, 24, 2), 0u);
            frames.emplace_back();
        } else if (chunk.type == "fdAT") {
            EXPECT_GT(frames.size(), 1u);
            EXPECT_EQ(number(chunk.data, 0), sequence++);
            frames.back() += chunk.data.substr(4);
        } else {
            EXPECT_EQ(chunk.type, "IDAT");
            EXPECT_EQ(frames.size(), 1u);
            frames.back() += chunk.data;
        }
    }
    ASSERT_EQ(frames.size(), count);
    for (std::uint32_t i = 0; i < count; ++i)
        EXPECT_EQ(decode_frame(chunks[0].data, frames[i]).rgba, frame(i).rgba) << i;
    // What knows no animation sees the first frame.
    const std::string png = written();
    EXPECT_EQ(decode(std::as_bytes(std::span(png)), "whole").rgba, frame(0).rgba);
}

TEST_F(Apng, MayHaveOneFrame) {
    ApngWriter writer(path, 7, 5, 1, 1);
    writer.add(frame(0));
    writer.publish();
    EXPECT_EQ(read_chunks(written()).size(), 5u) << "IHDR acTL fcTL IDAT IEND";
}

TEST_F(Apng, RefusesWhatDoesNotFit) {
    EXPECT_THROW(ApngWriter(path, 7, 5, 0, 30), Error);
    EXPECT_THROW(ApngWriter(path, 7, 5, 1, 0), Error);
    EXPECT_THROW(ApngWriter(path, 7, 5, 1, 1001), Error);
    EXPECT_THROW(ApngWriter(folder / "missing" / "x.apng", 7, 5, 1, 30), Error);
    {
        ApngWriter writer(path, 7, 5, 2, 30);
        EXPECT_THROW(writer.add(frame(0, 8, 5)), Error);
        writer.add(frame(0));
        EXPECT_THROW(writer.publish(), Error) << "a frame is missing";
        writer.add(frame(1));
        EXPECT_THROW(writer.add(frame(2)), Error);
    }
    EXPECT_FALSE(std::filesystem::exists(path));
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace
}  // namespace tessera::image
