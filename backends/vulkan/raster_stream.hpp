// A stream of work and the data it reads, in bounded memory: two arenas take turns, one filled by the host while the
// device works from the other.
#pragma once

#include <array>
#include <functional>

#include "backends/vulkan/memory.hpp"

namespace tessera::backends::vulkan {

class RasterStream {
public:
    /// Bytes of each of the two arenas; no piece may be larger.
    static constexpr std::uint64_t arena_size = 32ull << 20;

    /// A place for data, valid until the next call of reserve() or submit().
    struct Piece {
        vk::Buffer buffer;
        std::uint64_t offset;
        std::byte* data;
    };

    explicit RasterStream(const Context& context);
    RasterStream(const RasterStream&) = delete;
    RasterStream& operator=(const RasterStream&) = delete;
    ~RasterStream();

    /// What to record first and last in each command buffer. Set while nothing is recorded, that is after submit().
    void set_frame(std::function<void(const vk::raii::CommandBuffer&)> first,
                   std::function<void(const vk::raii::CommandBuffer&)> last);

    /// Room for `size` bytes at a multiple of 16. Where the arena is full, what was recorded is submitted and the other
    /// arena is taken: write the data, then record what reads it by commands().
    Piece reserve(std::uint64_t size);

    /// The command buffer being recorded; begun where there was none.
    const vk::raii::CommandBuffer& commands();

    /// Submits what was recorded, if anything.
    void submit();

    /// Submits, and waits until the device is done.
    void finish();

private:
    struct Arena {
        BufferAllocation buffer;
        vk::raii::CommandBuffer commands{nullptr};
        vk::raii::Fence done{nullptr};
        std::uint64_t used = 0;
        bool recording = false;
        bool submitted = false;
    };

    void wait(Arena& arena);

    const Context& context_;
    vk::raii::CommandPool pool_{nullptr};
    std::array<Arena, 2> arenas_;
    std::size_t current_ = 0;
    std::function<void(const vk::raii::CommandBuffer&)> first_, last_;
};

}  // namespace tessera::backends::vulkan
