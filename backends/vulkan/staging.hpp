// Moves bytes between the host and device memory that the host cannot touch: a ring for uploads, a block for
// read-backs. Both are made at first need and then reused.
#pragma once

#include <deque>

#include "backends/vulkan/objects.hpp"

namespace tessera::backends::vulkan {

class Staging {
public:
    Staging(const Context& context, Timeline& timeline) : context_(context), timeline_(timeline) {}

    /// The most bytes of one upload or read-back.
    static constexpr std::uint64_t piece_size = 2u << 20;

    struct Piece {
        vk::Buffer buffer;
        std::uint64_t offset;
        std::byte* mapped;
    };

    /// Room for `size` bytes (up to piece_size) that the commands recorded next read. Fill it, then call uploaded().
    /// Where the ring is full, sends what has been recorded and waits for the oldest part to be free again.
    Piece upload(std::uint64_t size);
    void uploaded(const Piece& piece, std::uint64_t size);

    /// Room for piece_size bytes; each call gives the same, so read it before the next. Call arrived() once the device
    /// has written.
    Piece readback();
    void arrived(std::uint64_t size);

    std::uint64_t allocations() const { return (*ring_.buffer ? 1 : 0) + (*block_.buffer ? 1 : 0); }

private:
    /// A part of the ring that a submission reads.
    struct Region {
        Timeline::Serial serial;
        std::uint64_t begin, end;
    };
    void make_room(std::uint64_t begin, std::uint64_t end);

    static constexpr std::uint64_t ring_size = 4 * piece_size;

    const Context& context_;
    Timeline& timeline_;
    BufferAllocation ring_, block_;
    std::deque<Region> regions_;  // oldest first
    std::uint64_t next_ = 0;
};

}  // namespace tessera::backends::vulkan
