// Adds up device time per stage from timestamps; silent where it is not asked to, and on devices that have none.
#pragma once

#include "gpu/device.hpp"
#include "tessellate/job.hpp"

namespace tessera {

/// Use per submission: begin(encoder), then mark(encoder, stage) after each stage, finish(encoder) before finishing
/// the encoder; collect() after submitting.
class StageClock {
public:
    StageClock(gpu::Device& device, bool asked);

    void begin(gpu::CommandEncoder& encoder);
    void mark(gpu::CommandEncoder& encoder, StageId stage);
    void finish(gpu::CommandEncoder& encoder);
    /// Waits for the submission and adds its times.
    void collect(gpu::Device& device);
    const StageTimes& times() const { return times_; }

private:
    static constexpr std::uint32_t capacity = 8;

    gpu::QuerySet queries_;
    gpu::Buffer resolved_;
    std::vector<StageId> marks_;
    bool pending_ = false;
    StageTimes times_;
};

}  // namespace tessera
