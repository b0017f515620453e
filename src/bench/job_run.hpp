// One job on one device, run again and again with its buffers kept.
#pragma once

#include "bench/workload.hpp"
#include "gpu/device.hpp"
#include "tessellate/job.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace tessera::bench {

/// What a job makes.
struct OutputSize {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t bytes() const { return vertices * 32 + triangles * 12; }
};

/// `workload` must outlive the run.
class JobRun {
public:
    /// `time_stages` measures each stage, which costs a wait after every submission: not for figures of whole jobs.
    JobRun(const gpu::Device& device, const Workload& workload, bool time_stages = false);

    /// The whole job: factors, counts, scan, control nets, vertices, triangles; returns when the device is done.
    void run();
    /// Size of the output, after the first run.
    const OutputSize& size() const { return size_; }
    /// Device seconds per stage of the last run; all zero where the device has no timestamps.
    std::array<double, stage_count> stage_seconds() const { return stages_; }
    /// Commands and bytes of the last run.
    const gpu::Traffic& traffic() const { return traffic_; }
    /// Device memory of the job without its outputs and inputs, over the bytes of its output buffers.
    double extra_memory() const;

private:
    gpu::Device device_;
    const Workload& workload_;
    Job job_;
    OutputSize size_;
    std::array<double, stage_count> stages_{};
    gpu::Traffic traffic_;
};

/// What a job wrote, to be held against that of another device.
struct OutputCheck {
    std::uint64_t unwritten = 0;  ///< words that still hold the sentinel
    std::uint64_t vertex_hash = 0;
    std::uint64_t index_hash = 0;
};

/// Runs the job once with its outputs filled with a sentinel first, and reads everything back.
OutputCheck check_output(const gpu::Device& device, const Workload& workload);

}  // namespace tessera::bench
