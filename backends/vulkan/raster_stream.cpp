#include "backends/vulkan/raster_stream.hpp"

#include <cassert>
#include <limits>

#include "backends/vulkan/errors.hpp"

namespace tessera::backends::vulkan {

RasterStream::RasterStream(const Context& context) : context_(context) {
    guarded("preparing to upload", [&] {
        pool_ = vk::raii::CommandPool(context.device,
                                      vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eResetCommandBuffer |
                                                                    vk::CommandPoolCreateFlagBits::eTransient,
                                                                context.queue_family));
        for (Arena& arena : arenas_) {
            using Usage = vk::BufferUsageFlagBits;
            arena.buffer =
                create_buffer(context, arena_size, Usage::eVertexBuffer | Usage::eIndexBuffer | Usage::eTransferSrc,
                              MemoryUse::upload, "vertices, indices and texels");
            vk::raii::CommandBuffers made(context.device,
                                          vk::CommandBufferAllocateInfo(*pool_, vk::CommandBufferLevel::ePrimary, 1));
            arena.commands = std::move(made.front());
            arena.done = vk::raii::Fence(context.device, vk::FenceCreateInfo());
        }
    });
}

RasterStream::~RasterStream() {
    // What the device still reads must live until it is done; a lost device reads nothing.
    try {
        for (Arena& arena : arenas_)
            wait(arena);
    } catch (const std::exception&) {
    }
}

void RasterStream::set_frame(std::function<void(const vk::raii::CommandBuffer&)> first,
                             std::function<void(const vk::raii::CommandBuffer&)> last) {
    assert(!arenas_[current_].recording);
    first_ = std::move(first);
    last_ = std::move(last);
}

RasterStream::Piece RasterStream::reserve(std::uint64_t size) {
    assert(size <= arena_size);
    if (arenas_[current_].used + size > arena_size) submit();
    commands();  // waits until the arena is free
    Arena& arena = arenas_[current_];
    const std::uint64_t offset = arena.used;
    arena.used += (size + 15) / 16 * 16;
    return {*arena.buffer.buffer, offset, arena.buffer.allocation.mapped + offset};
}

const vk::raii::CommandBuffer& RasterStream::commands() {
    Arena& arena = arenas_[current_];
    if (!arena.recording) {
        wait(arena);
        guarded("recording a picture", [&] {
            arena.commands.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
        });
        arena.recording = true;
        if (first_) first_(arena.commands);
    }
    return arena.commands;
}

void RasterStream::submit() {
    Arena& arena = arenas_[current_];
    if (!arena.recording) return;
    if (last_) last_(arena.commands);
    arena.recording = false;
    flush(context_, arena.buffer.allocation, 0, arena.used);
    guarded("submitting a picture", [&] {
        arena.commands.end();
        context_.queue.submit(vk::SubmitInfo({}, {}, *arena.commands), *arena.done);
    });
    arena.submitted = true;
    current_ = 1 - current_;
}

void RasterStream::finish() {
    submit();
    for (Arena& arena : arenas_)
        wait(arena);
}

void RasterStream::wait(Arena& arena) {
    if (!arena.submitted) return;
    arena.submitted = false;
    guarded("drawing a picture", [&] {
        const vk::Result result =
            context_.device.waitForFences(*arena.done, VK_TRUE, std::numeric_limits<std::uint64_t>::max());
        if (result != vk::Result::eSuccess) throw vk::SystemError(vk::make_error_code(result));
        context_.device.resetFences(*arena.done);
    });
    arena.used = 0;
}

}  // namespace tessera::backends::vulkan
