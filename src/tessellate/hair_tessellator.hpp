// Makes the hair of a scene on a device and hands it on in batches, like Tessellator for surfaces.
#pragma once

#include "tessellate/hair_job.hpp"
#include "tessellate/tessellate.hpp"

namespace tessera {

class HairTessellator {
public:
    /// Counts the output. Device and hair must outlive the tessellator; `hair` is not empty. Throws Error(usage) for
    /// options that do not fit; see HairJob.
    HairTessellator(const gpu::Device& device, const patches::HairSet& hair, const HairOptions& options);

    /// One part for each of the scene's Guides.
    const MeshTotals& totals() const { return totals_; }
    /// From now on ribbons face this place in kernel space: the eye of a camera fitted to Space::kernel. Totals stay.
    void face(const glm::vec3& eye) { job_.face(eye); }
    /// Makes the output and hands it to `sink`, whose numbering has come to `first_vertex` and `first_index`.
    /// `progress` (may be empty) is called with the fraction done. Throws Error(usage) where an index would need more
    /// than 32 bits.
    void run(MeshSink& sink, std::uint64_t first_vertex = 0, std::uint64_t first_index = 0, Space space = Space::model,
             const std::function<void(double)>& progress = {});

    const StageTimes& times() { return job_.times(); }
    std::uint64_t device_bytes() const { return job_.device_bytes(); }

private:
    gpu::Device device_;
    const patches::HairSet& hair_;
    HairJob job_;
    MeshTotals totals_;
    std::size_t counted_chunk_ = 0;  // whose counts are on the device now
};

/// Makes hair in memory.
RefinedMesh tessellate_hair(const gpu::Device& device, const patches::HairSet& hair, const HairOptions& options);

}  // namespace tessera
