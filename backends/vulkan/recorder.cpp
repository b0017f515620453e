#include "backends/vulkan/recorder.hpp"

#include <algorithm>
#include <cstring>

namespace tessera::backends::vulkan {
namespace {

Buffer& buffer_of(gpu::BackendObject* object) {
    return static_cast<Buffer&>(*object);
}

/// Orders all commands before it with all after it, for every way in which ours touch memory.
void full_barrier(const vk::raii::CommandBuffer& commands) {
    using BufferAccess = vk::AccessFlagBits;
    using Stage = vk::PipelineStageFlagBits;
    const vk::MemoryBarrier barrier(BufferAccess::eShaderWrite | BufferAccess::eTransferWrite,
                                    BufferAccess::eShaderRead | BufferAccess::eShaderWrite |
                                        BufferAccess::eUniformRead | BufferAccess::eTransferRead |
                                        BufferAccess::eTransferWrite | BufferAccess::eIndirectCommandRead);
    // Reads need no access mask, but a later write must wait for them: DrawIndirect is the stage that reads arguments.
    commands.pipelineBarrier(Stage::eComputeShader | Stage::eTransfer | Stage::eDrawIndirect,
                             Stage::eComputeShader | Stage::eTransfer | Stage::eDrawIndirect, {}, barrier, {}, {});
}

}  // namespace

void Recorder::record(const gpu::Command& command) {
    std::visit([this](const auto& one) { record(one); }, command);
}

const vk::raii::CommandBuffer& Recorder::begin_command(std::span<const BufferAccess> accesses) {
    const vk::raii::CommandBuffer& commands = timeline_.recording();
    if (hazards_.next_command(accesses)) {
        full_barrier(commands);
        ++barriers_;
    }
    return commands;
}

void Recorder::bind(const vk::raii::CommandBuffer& commands, Pipeline& pipeline, BindGroup& group,
                    std::uint32_t uniform_offset) {
    dynamic_.assign(group.uniforms, uniform_offset);
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline.vulkan->pipeline);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *pipeline.vulkan->layout, 0, *group.vulkan.get(),
                                dynamic_);
    pipeline.vulkan.use();
    group.vulkan.use();
    for (Buffer* buffer : group.buffers)
        buffer->vulkan.use();
}

void Recorder::record(const gpu::Dispatch& command) {
    if (command.groups_x == 0 || command.groups_y == 0) return;
    auto& group = static_cast<BindGroup&>(*command.bind_group);
    const vk::raii::CommandBuffer& commands = begin_command(group.accesses);
    bind(commands, static_cast<Pipeline&>(*command.pipeline), group, command.uniform_offset);
    commands.dispatch(command.groups_x, command.groups_y, 1);
}

void Recorder::record(const gpu::DispatchIndirect& command) {
    auto& group = static_cast<BindGroup&>(*command.bind_group);
    Buffer& arguments = buffer_of(command.arguments);
    accesses_.assign(group.accesses.begin(), group.accesses.end());
    accesses_.push_back({&arguments.last_access, false});
    const vk::raii::CommandBuffer& commands = begin_command(accesses_);
    bind(commands, static_cast<Pipeline&>(*command.pipeline), group, command.uniform_offset);
    arguments.vulkan.use();
    commands.dispatchIndirect(*arguments.vulkan->buffer, command.arguments_offset);
}

void Recorder::record(const gpu::CopyBuffer& command) {
    if (command.size == 0) return;
    Buffer& source = buffer_of(command.source);
    Buffer& destination = buffer_of(command.destination);
    const std::array<BufferAccess, 2> accesses = {{{&source.last_access, false}, {&destination.last_access, true}}};
    const vk::raii::CommandBuffer& commands = begin_command(accesses);
    source.vulkan.use();
    destination.vulkan.use();
    commands.copyBuffer(*source.vulkan->buffer, *destination.vulkan->buffer,
                        vk::BufferCopy(command.source_offset, command.destination_offset, command.size));
}

void Recorder::record(const gpu::FillBuffer& command) {
    if (command.size == 0) return;
    Buffer& buffer = buffer_of(command.buffer);
    const std::array<BufferAccess, 1> accesses = {{{&buffer.last_access, true}}};
    const vk::raii::CommandBuffer& commands = begin_command(accesses);
    buffer.vulkan.use();
    commands.fillBuffer(*buffer.vulkan->buffer, command.offset, command.size, command.value);
}

void Recorder::record(const gpu::WriteTimestamp& command) {
    auto& queries = static_cast<QuerySet&>(*command.query_set);
    const vk::raii::CommandBuffer& commands = timeline_.recording();
    commands.resetQueryPool(*queries.vulkan.get(), command.index, 1);
    // At the bottom of the pipe: the time when everything recorded before is done.
    commands.writeTimestamp(vk::PipelineStageFlagBits::eBottomOfPipe, *queries.vulkan.get(), command.index);
    queries.vulkan.use();
    queries.written[command.index] = true;
}

/// Ticks become nanoseconds on the host, so a resolve waits for the work before it. Timestamps serve measurements;
/// nothing else in a submission waits.
void Recorder::record(const gpu::ResolveQuerySet& command) {
    auto& queries = static_cast<QuerySet&>(*command.query_set);
    timeline_.wait_all();
    const std::uint32_t bits = context_.queue_properties.timestampValidBits;
    const std::uint64_t mask = bits < 64 ? (1ull << bits) - 1 : ~0ull;
    const long double period = static_cast<long double>(context_.properties.limits.timestampPeriod);
    std::vector<std::uint64_t> nanoseconds(command.count, 0);
    for (std::uint32_t i = 0; i < command.count; ++i) {
        if (!queries.written[command.first + i]) continue;
        const auto [result, ticks] = queries.vulkan->getResult<std::uint64_t>(
            command.first + i, 1, sizeof(std::uint64_t), vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
        nanoseconds[i] = static_cast<std::uint64_t>(static_cast<long double>(ticks & mask) * period);
    }
    write(buffer_of(command.destination), command.offset, std::as_bytes(std::span(nanoseconds)));
}

void Recorder::clear(Buffer& buffer, std::uint64_t size) {
    const Allocation& memory = buffer.vulkan->allocation;
    if (memory.mapped == nullptr) {
        record(gpu::FillBuffer{&buffer, 0, size, 0});
        return;
    }
    std::memset(memory.mapped, 0, size);
    flush(context_, memory, 0, size);
}

void Recorder::write(Buffer& buffer, std::uint64_t offset, std::span<const std::byte> data) {
    const Allocation& memory = buffer.vulkan->allocation;
    if (memory.mapped != nullptr && buffer.vulkan.idle()) {
        std::memcpy(memory.mapped + offset, data.data(), data.size());
        flush(context_, memory, offset, data.size());
        return;
    }
    while (!data.empty()) {
        const std::uint64_t size = std::min<std::uint64_t>(data.size(), Staging::piece_size);
        const Staging::Piece piece = staging_.upload(size);
        std::memcpy(piece.mapped, data.data(), size);
        staging_.uploaded(piece, size);
        const std::array<BufferAccess, 1> accesses = {{{&buffer.last_access, true}}};
        const vk::raii::CommandBuffer& commands = begin_command(accesses);
        buffer.vulkan.use();
        commands.copyBuffer(piece.buffer, *buffer.vulkan->buffer, vk::BufferCopy(piece.offset, offset, size));
        offset += size;
        data = data.subspan(size);
    }
}

void Recorder::read(Buffer& buffer, std::uint64_t offset, std::span<std::byte> data) {
    const Allocation& memory = buffer.vulkan->allocation;
    if (memory.mapped != nullptr) {
        timeline_.wait_all();
        invalidate(context_, memory, offset, data.size());
        std::memcpy(data.data(), memory.mapped + offset, data.size());
        return;
    }
    while (!data.empty()) {
        const std::uint64_t size = std::min<std::uint64_t>(data.size(), Staging::piece_size);
        const Staging::Piece piece = staging_.readback();
        const std::array<BufferAccess, 1> accesses = {{{&buffer.last_access, false}}};
        const vk::raii::CommandBuffer& commands = begin_command(accesses);
        buffer.vulkan.use();
        commands.copyBuffer(*buffer.vulkan->buffer, piece.buffer, vk::BufferCopy(offset, piece.offset, size));
        timeline_.wait_all();
        staging_.arrived(size);
        std::memcpy(data.data(), piece.mapped, size);
        offset += size;
        data = data.subspan(size);
    }
}

}  // namespace tessera::backends::vulkan
