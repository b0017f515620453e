#include "tessellate/stage_clock.hpp"

namespace tessera {

StageClock::StageClock(gpu::Device& device, bool asked) {
    times_.measured = asked && device.info().timestamps;
    if (times_.measured) {
        queries_ = device.create_query_set(capacity);
        resolved_ = device.create_buffer(
            {"timestamps", capacity * 8, gpu::BufferUsage::query_resolve | gpu::BufferUsage::copy_source});
    }
}

void StageClock::begin(gpu::CommandEncoder& encoder) {
    marks_.clear();
    if (times_.measured) {
        encoder.write_timestamp(queries_, 0);
    }
}

void StageClock::mark(gpu::CommandEncoder& encoder, StageId stage) {
    if (times_.measured) {
        marks_.push_back(stage);
        encoder.write_timestamp(queries_, static_cast<std::uint32_t>(marks_.size()));
    }
}

void StageClock::finish(gpu::CommandEncoder& encoder) {
    if (times_.measured) {
        encoder.resolve_query_set(queries_, 0, static_cast<std::uint32_t>(marks_.size()) + 1, resolved_, 0);
        pending_ = true;
    }
}

void StageClock::collect(gpu::Device& device) {
    if (!pending_) {
        return;
    }
    std::array<std::uint64_t, capacity> stamps{};
    device.queue().read_buffer(resolved_, 0, std::as_writable_bytes(std::span(stamps).first(marks_.size() + 1)));
    for (std::size_t i = 0; i < marks_.size(); ++i) {
        times_.seconds[static_cast<std::size_t>(marks_[i])] += static_cast<double>(stamps[i + 1] - stamps[i]) * 1e-9;
    }
    pending_ = false;
}

}  // namespace tessera
