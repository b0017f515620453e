// One job of hair on one device: the isoline twin of Job, with the same steps and views. A chunk is made of hair
// patches of at most 64 hairs each; what `views` call control nets are the curves of the guides.
#pragma once

#include "patches/hair.hpp"
#include "tessellate/hair_options.hpp"
#include "tessellate/job.hpp"

namespace tessera {

/// Device and hair must outlive the job. See Job for what the steps do.
class HairJob {
public:
    /// Throws Error(usage) for options out of range and for guides or a budget that do not fit; `hair` is not empty.
    HairJob(gpu::Device device, const patches::HairSet& hair, const HairOptions& options, const gpu::Limits& limits);
    ~HairJob();

    void poison_outputs(std::uint32_t word);
    /// From now on ribbons face this place in kernel space, where the largest coordinate of the model is near 1.
    void face(const glm::vec3& eye);

    /// How many patches of the job one patch of the set becomes; part i of the set's patch p is p * parts_per_patch() +
    /// i.
    std::uint32_t parts_per_patch() const;
    std::size_t chunk_count() const;
    const Chunk& chunk(std::size_t index) const;
    /// Offsets count the vertices and indices of ribbons.
    const std::vector<PatchOffset>& count(std::size_t chunk);
    const std::vector<Batch>& prepare();
    void emit(const Batch& batch, std::uint32_t vertex_base);

    std::vector<StageView> prepared_views() const;
    std::vector<StageView> emitted_views() const;
    const StageTimes& times();
    std::uint64_t device_bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace tessera
