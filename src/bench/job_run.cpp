#include "bench/job_run.hpp"

#include "bench/sanity.hpp"

#include <algorithm>

namespace tessera::bench {

namespace {

TessellationOptions timed(TessellationOptions options, bool time_stages) {
    options.time_stages = time_stages;
    return options;
}

}  // namespace

JobRun::JobRun(const gpu::Device& device, const Workload& workload, bool time_stages)
    : device_(device),
      workload_(workload),
      job_(device, workload.patches, timed(workload.options, time_stages), device.limits()) {}

void JobRun::run() {
    const gpu::Traffic before = device_.traffic();
    const std::array<double, stage_count> stages_before = job_.times().seconds;
    OutputSize size;
    for (std::size_t chunk = 0; chunk < job_.chunk_count(); ++chunk) {
        job_.count(chunk);
        for (const Batch& batch : job_.prepare()) {
            job_.emit(batch, static_cast<std::uint32_t>(size.vertices));
            size.vertices += batch.vertex_count;
            size.triangles += batch.index_count / 3;
        }
    }
    device_.queue().wait();
    const std::array<double, stage_count>& stages_now = job_.times().seconds;
    for (std::size_t i = 0; i < stage_count; ++i) {
        stages_[i] = stages_now[i] - stages_before[i];
    }
    const gpu::Traffic& now = device_.traffic();
    traffic_ = {now.submits - before.submits, now.dispatches - before.dispatches, now.uploaded - before.uploaded,
                now.read - before.read};
    size_ = size;
}

double JobRun::extra_memory() const {
    std::uint64_t outputs = 0;
    for (const StageView& view : job_.emitted_views()) {
        outputs += view.buffer ? view.buffer.size() : 0;
    }
    const patches::PatchSet& patches = workload_.patches;
    const bool per_patch = std::holds_alternative<std::vector<PatchFactors>>(workload_.options.factors);
    const std::uint64_t inputs = patches.control_vertices.size() * sizeof(Vertex) +
                                 patches.patch_count() * sizeof(patches::PatchCorners) +
                                 (per_patch ? patches.patch_count() : 1) * sizeof(PatchFactors);
    const std::uint64_t all = job_.device_bytes();
    const std::uint64_t extra = all - std::min(all, outputs + inputs);
    return outputs == 0 ? 0.0 : static_cast<double>(extra) / static_cast<double>(outputs);
}

OutputCheck check_output(const gpu::Device& device, const Workload& workload) {
    Job job(device, workload.patches, workload.options, device.limits());
    job.poison_outputs(sentinel);
    OutputCheck check{0, hash_start, hash_start};
    std::vector<std::uint32_t> words;
    std::uint64_t vertices = 0;
    for (std::size_t chunk = 0; chunk < job.chunk_count(); ++chunk) {
        job.count(chunk);
        for (const Batch& batch : job.prepare()) {
            job.emit(batch, static_cast<std::uint32_t>(vertices));
            vertices += batch.vertex_count;
            for (const StageView& view : job.emitted_views()) {
                words.resize(view.bytes / 4);
                device.queue().read_buffer(view.buffer, 0, std::as_writable_bytes(std::span(words)));
                check.unwritten += count_unwritten(words);
                std::uint64_t& hash = view.stage == StageId::vertices ? check.vertex_hash : check.index_hash;
                hash = hash_words(words, hash);
            }
        }
    }
    return check;
}

}  // namespace tessera::bench
