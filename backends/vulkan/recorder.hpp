// Records commands with the barriers that they need, and moves data in the same order.
#pragma once

#include "backends/vulkan/staging.hpp"

namespace tessera::backends::vulkan {

class Recorder {
public:
    Recorder(const Context& context, Timeline& timeline)
        : context_(context), timeline_(timeline), staging_(context, timeline) {}

    void record(const gpu::Command& command);
    /// Sets the `size` bytes of a new buffer to zero, for the device may hand out memory that was used before.
    void clear(Buffer& buffer, std::uint64_t size);
    /// Ordered with what is recorded; may wait when more is uploaded than the ring holds.
    void write(Buffer& buffer, std::uint64_t offset, std::span<const std::byte> data);
    /// Sends what is recorded and waits for it.
    void read(Buffer& buffer, std::uint64_t offset, std::span<std::byte> data);

    std::uint64_t barriers() const { return barriers_; }
    std::uint64_t allocations() const { return staging_.allocations(); }

private:
    void record(const gpu::Dispatch& command);
    void record(const gpu::DispatchIndirect& command);
    void record(const gpu::CopyBuffer& command);
    void record(const gpu::FillBuffer& command);
    void record(const gpu::WriteTimestamp& command);
    void record(const gpu::ResolveQuerySet& command);

    /// The open command buffer, after the barrier that `accesses` need.
    const vk::raii::CommandBuffer& begin_command(std::span<const BufferAccess> accesses);
    void bind(const vk::raii::CommandBuffer& commands, Pipeline& pipeline, BindGroup& group,
              std::uint32_t uniform_offset);

    const Context& context_;
    Timeline& timeline_;
    Staging staging_;
    Hazards hazards_;
    std::vector<BufferAccess> accesses_;  // reused by indirect dispatches
    std::vector<std::uint32_t> dynamic_;  // reused by bind
    std::uint64_t barriers_ = 0;
};

}  // namespace tessera::backends::vulkan
