// Tessellates patches on a device and hands the result on in batches. The whole pipeline in one call:
//   1 factors  2 control nets  3 counts  4 scan  5 vertices  6 indices  and, where asked for, 7 tangents
//   and, where patches have any, 8 attributes (colours, tangents of normal maps)
#pragma once

#include "gpu/device.hpp"
#include "patches/patches.hpp"
#include "tessellate/job.hpp"
#include "tessellate/options.hpp"
#include "tessellate/refined_mesh.hpp"

#include <functional>

namespace tessera {

/// The units of output positions: the model's, or the scaled ones of the kernels (largest coordinate near 1), which
/// suit renderers whatever the size of the model.
enum class Space { model, kernel };

/// Runs a job in two steps, so that a receiver learns the sizes before the first byte.
class Tessellator {
public:
    /// Counts the output. Device and patches must outlive the tessellator. Throws Error(usage) for options that do not
    /// fit; see Job.
    Tessellator(const gpu::Device& device, const patches::PatchSet& patches, const TessellationOptions& options);

    /// Sizes of the whole output and of the part made from each mesh of the scene.
    const MeshTotals& totals() const { return totals_; }
    /// Makes the output and hands it to `sink`. `progress` (may be empty) is called with the fraction done. Throws
    /// Error(usage) where an index would need more than 32 bits. Can be called again.
    void run(MeshSink& sink, Space space = Space::model, const std::function<void(double)>& progress = {});

    const StageTimes& times() { return job_.times(); }
    std::uint64_t device_bytes() const { return job_.device_bytes(); }

private:
    gpu::Device device_;
    const patches::PatchSet& patches_;
    Job job_;
    std::vector<std::uint32_t> read_records();

    MeshTotals totals_;
    bool marks_quads_ = false;
    std::size_t counted_chunk_ = 0;  // whose counts are on the device now
};

/// A whole output in memory.
struct RefinedMesh : MeshSink {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<Tangent> tangents;             ///< one per vertex, or none
    std::vector<VertexAttributes> attributes;  ///< likewise
    std::vector<MeshPart> parts;

    void append(const MeshBatch& batch) override;
};

/// Tessellates into memory.
RefinedMesh tessellate(const gpu::Device& device, const patches::PatchSet& patches, const TessellationOptions& options);

}  // namespace tessera
