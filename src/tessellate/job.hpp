// One tessellation job on one device, chunk by chunk and batch by batch, with every stage's buffer open to view:
// tessellate() drives one job to a sink, verify drives two in step and compares.
#pragma once

#include "gpu/device.hpp"
#include "patches/patches.hpp"
#include "tessellate/patch_counter.hpp"
#include "tessellate/plan.hpp"

#include <memory>

namespace tessera {

/// The stages in the order of their work. Only jobs that are asked for tangents make them, and only those of patches
/// with colours or normal maps have attributes.
enum class StageId { factors, control_nets, counts, scan, vertices, indices, tangents, attributes };
inline constexpr std::size_t stage_count = 8;
std::string_view name(StageId stage);

/// A stage's output as it lies on the device after prepare() or emit().
struct StageView {
    StageId stage;
    gpu::Buffer buffer;
    std::uint64_t bytes = 0;
    bool floats = false;  ///< elements are floats, else uint32
};

/// Time spent on the device per stage, in seconds, summed over the job; empty where the device has no timestamps.
struct StageTimes {
    std::array<double, stage_count> seconds{};
    bool measured = false;
};

/// Device, patches and options must outlive the job. Everything runs on the device's queue; prepare() and emit() return
/// once their commands are submitted, reading a view waits.
class Job {
public:
    /// Makes the plan from `limits` (so that two devices can share one: pass the smaller of each limit) and allocates
    /// what a chunk needs. Throws Error(usage) for options that do not fit the patches or the memory budget.
    Job(gpu::Device device, const patches::PatchSet& patches, const TessellationOptions& options,
        const gpu::Limits& limits);
    ~Job();

    /// From now on fills every output with `word` before the stage that writes it, so that elements left unwritten
    /// show.
    void poison_outputs(std::uint32_t word);

    std::size_t chunk_count() const;
    const Chunk& chunk(std::size_t index) const;
    /// Runs factors, counts and scan of a chunk and returns its offsets: one per patch and the totals.
    const std::vector<PatchOffset>& count(std::size_t chunk);
    /// The offsets of the chunk counted last.
    const std::vector<PatchOffset>& offsets() const;
    /// Runs the control nets of the chunk counted last, and cuts it into batches.
    const std::vector<Batch>& prepare();
    /// Emits one batch of that chunk. `vertex_base` is added to every index.
    void emit(const Batch& batch, std::uint32_t vertex_base);

    /// What count() and prepare() left on the device: factors, control nets, counts, scan.
    std::vector<StageView> prepared_views() const;
    /// What the last emit() left: vertices, indices and, where the job makes them, tangents and attributes.
    std::vector<StageView> emitted_views() const;
    /// Waits, and adds up what has run so far.
    const StageTimes& times();
    /// Device memory held by the job now, in bytes.
    std::uint64_t device_bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace tessera
