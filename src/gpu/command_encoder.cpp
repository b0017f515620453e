#include "gpu/validation.hpp"

#include <algorithm>

namespace tessera::gpu {

namespace {

/// The state of an encoder that can record outside of a pass.
detail::EncoderState& recording(const CommandEncoder& encoder, std::string_view call) {
    detail::EncoderState& state = detail::not_null(encoder.state_, call, "command encoder");
    if (state.finished) {
        detail::refuse("{} came after finish of its command encoder; make a new encoder.", call);
    }
    if (state.open_pass != 0) {
        detail::refuse("{} came while compute pass {} of its command encoder is open; end the pass first.", call,
                       state.open_pass);
    }
    return state;
}

detail::QueryUse& query_use(detail::Recording& recording, const QuerySet& queries) {
    const auto found = std::ranges::find(recording.queries, queries.state_, &detail::QueryUse::set);
    if (found != recording.queries.end()) {
        return *found;
    }
    const std::vector<bool> none(queries.state_->count);
    return recording.queries.emplace_back(detail::QueryUse{queries.state_, none, none});
}

}  // namespace

ComputePass CommandEncoder::begin_compute_pass() {
    detail::EncoderState& state = recording(*this, "begin_compute_pass");
    state.open_pass = ++state.passes;
    state.pipeline = nullptr;
    state.bind_group = nullptr;
    state.uniform_offset = 0;
    ComputePass pass;
    pass.state_ = state_;
    pass.number_ = state.open_pass;
    return pass;
}

void CommandEncoder::copy_buffer_to_buffer(const Buffer& source, std::uint64_t source_offset, const Buffer& destination,
                                           std::uint64_t destination_offset, std::uint64_t size) {
    constexpr std::string_view call = "copy_buffer_to_buffer";
    detail::EncoderState& state = recording(*this, call);
    detail::BufferState& from = detail::require_buffer(source, *state.device, call, BufferUsage::copy_source);
    detail::BufferState& to = detail::require_buffer(destination, *state.device, call, BufferUsage::copy_destination);
    if (&from == &to) {
        detail::refuse("{} got buffer '{}' as source and as destination; they must differ.", call,
                       from.descriptor.label);
    }
    detail::require_range(from, call, source_offset, size);
    detail::require_range(to, call, destination_offset, size);
    if (size != 0) {
        state.recording.hold(state.recording.buffers, source.state_);
        state.recording.hold(state.recording.buffers, destination.state_);
        state.recording.commands.emplace_back(
            CopyBuffer{from.object.get(), source_offset, to.object.get(), destination_offset, size});
    }
}

void CommandEncoder::fill_buffer(const Buffer& buffer, std::uint64_t offset, std::uint64_t size, std::uint32_t value) {
    constexpr std::string_view call = "fill_buffer";
    detail::EncoderState& state = recording(*this, call);
    detail::BufferState& target = detail::require_buffer(buffer, *state.device, call, BufferUsage::copy_destination);
    detail::require_range(target, call, offset, size);
    if (size != 0) {
        state.recording.hold(state.recording.buffers, buffer.state_);
        state.recording.commands.emplace_back(FillBuffer{target.object.get(), offset, size, value});
    }
}

void CommandEncoder::write_timestamp(const QuerySet& queries, std::uint32_t index) {
    constexpr std::string_view call = "write_timestamp";
    detail::EncoderState& state = recording(*this, call);
    const detail::QuerySetState& set = detail::require_query_set(queries, *state.device, call);
    if (index >= set.count) {
        detail::refuse("{} got index {} in a query set of {} timestamps.", call, index, set.count);
    }
    query_use(state.recording, queries).written[index] = true;
    state.recording.commands.emplace_back(WriteTimestamp{set.object.get(), index});
}

void CommandEncoder::resolve_query_set(const QuerySet& queries, std::uint32_t first, std::uint32_t count,
                                       const Buffer& destination, std::uint64_t offset) {
    constexpr std::string_view call = "resolve_query_set";
    detail::EncoderState& state = recording(*this, call);
    const detail::QuerySetState& set = detail::require_query_set(queries, *state.device, call);
    if (first > set.count || count > set.count - first) {
        detail::refuse("{} got {} timestamps from index {} of a query set of {}.", call, count, first, set.count);
    }
    detail::BufferState& target = detail::require_buffer(destination, *state.device, call, BufferUsage::query_resolve);
    detail::require_range(target, call, offset, std::uint64_t{count} * sizeof(std::uint64_t), sizeof(std::uint64_t));
    if (count == 0) {
        return;
    }
    detail::QueryUse& use = query_use(state.recording, queries);
    for (std::uint32_t i = first; i < first + count; ++i) {
        use.awaited[i] = use.awaited[i] || !use.written[i];
    }
    state.recording.hold(state.recording.buffers, destination.state_);
    state.recording.commands.emplace_back(ResolveQuerySet{set.object.get(), first, count, target.object.get(), offset});
}

CommandBuffer CommandEncoder::finish() {
    detail::EncoderState& state = recording(*this, "finish");
    state.finished = true;
    CommandBuffer commands;
    commands.state_ = std::make_shared<detail::CommandBufferState>();
    commands.state_->device = state.device;
    commands.state_->recording = std::move(state.recording);
    return commands;
}

}  // namespace tessera::gpu
