#include "image/apng.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <zlib.h>
#include <algorithm>
#include <string_view>

namespace tessera::image {
namespace {

constexpr std::size_t signature_bytes = 8;

void append_number(std::vector<std::byte>& bytes, std::uint32_t value, int width = 4) {
    for (int shift = 8 * (width - 1); shift >= 0; shift -= 8)
        bytes.push_back(static_cast<std::byte>(value >> shift & 255u));
}

void append_chunk(std::vector<std::byte>& bytes, std::string_view type, std::span<const std::byte> data) {
    append_number(bytes, static_cast<std::uint32_t>(data.size()));
    const std::size_t start = bytes.size();
    for (const char letter : type)
        bytes.push_back(static_cast<std::byte>(letter));
    bytes.insert(bytes.end(), data.begin(), data.end());
    const auto* covered = reinterpret_cast<const Bytef*>(bytes.data() + start);
    append_number(bytes, static_cast<std::uint32_t>(crc32_z(0, covered, bytes.size() - start)));
}

struct Chunk {
    std::string_view type;
    std::span<const std::byte> data;
};

/// The chunks of a PNG of our own.
std::vector<Chunk> chunks_of(std::span<const std::byte> png) {
    std::vector<Chunk> chunks;
    for (std::size_t at = signature_bytes; at + 12 <= png.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i)
            length = length << 8 | std::to_integer<std::size_t>(png[at + i]);
        chunks.push_back({{reinterpret_cast<const char*>(&png[at + 4]), 4}, png.subspan(at + 8, length)});
        at += 12 + length;
    }
    return chunks;
}

Error cannot(const std::string& reason) {
    return {ErrorKind::output, "An animated PNG cannot be written: " + reason + "."};
}

}  // namespace

ApngWriter::ApngWriter(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                       std::uint32_t frame_count, std::uint32_t frames_per_second)
    : file_(path), width_(width), height_(height), frame_count_(frame_count), frames_per_second_(frames_per_second) {
    if (frame_count == 0) throw cannot("it has no frames");
    if (frames_per_second < 1 || frames_per_second > 1000) {
        throw cannot(fmt::format("{} frames per second are not in [1, 1000]", frames_per_second));
    }
}

void ApngWriter::write(const std::vector<std::byte>& bytes) {
    file_.write_at(written_, bytes);
    written_ += bytes.size();
}

void ApngWriter::add(const Image& frame) {
    if (frame.width != width_ || frame.height != height_) {
        throw cannot(fmt::format("frame {} has {} x {} pixels instead of {} x {}", frames_, frame.width, frame.height,
                                 width_, height_));
    }
    if (frames_ == frame_count_) throw cannot(fmt::format("it has more than its {} frames", frame_count_));
    const std::vector<std::byte> png = encode_png(frame);
    const std::vector<Chunk> chunks = chunks_of(png);

    std::vector<std::byte> out;
    if (frames_ == 0) {
        out.assign(png.begin(), png.begin() + signature_bytes);
        append_chunk(out, chunks.front().type, chunks.front().data);
        std::vector<std::byte> animation;
        append_number(animation, frame_count_);
        append_number(animation, 0);  // plays: for ever
        append_chunk(out, "acTL", animation);
    }
    std::vector<std::byte> control;
    for (const std::uint32_t value : {sequence_++, width_, height_, 0u, 0u})
        append_number(control, value);
    append_number(control, 1, 2);  // it stays for this many seconds over
    append_number(control, frames_per_second_, 2);
    append_number(control, 0, 1);  // afterwards it stays as it is
    append_number(control, 0, 1);  // and the next one replaces it
    append_chunk(out, "fcTL", control);
    for (const Chunk& chunk : chunks) {
        if (chunk.type != "IDAT") continue;
        if (frames_ == 0) {
            append_chunk(out, "IDAT", chunk.data);
        } else {
            std::vector<std::byte> data;
            append_number(data, sequence_++);
            data.insert(data.end(), chunk.data.begin(), chunk.data.end());
            append_chunk(out, "fdAT", data);
        }
    }
    ++frames_;
    if (frames_ == frame_count_) append_chunk(out, "IEND", {});
    write(out);
}

void ApngWriter::publish() {
    if (frames_ != frame_count_) throw cannot(fmt::format("it has {} of {} frames", frames_, frame_count_));
    file_.publish();
}

}  // namespace tessera::image
