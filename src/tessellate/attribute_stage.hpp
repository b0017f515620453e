// The stage of a job that makes the colours and tangents of vertices; nothing where the patches have none.
#pragma once

#include "patches/patches.hpp"
#include "tessellate/options.hpp"
#include "tessellate/stage.hpp"

#include <array>

namespace tessera {

class AttributeStage {
public:
    /// `patches` and `parameters` must outlive the stage. `largest_chunk` counts patches.
    AttributeStage(const gpu::Device& device, const patches::PatchSet& patches, const ParameterRing& parameters,
                   std::uint32_t largest_chunk);

    bool is_wanted() const { return !patches_.corner_attributes.empty(); }
    /// Uploads the corners of patches [first, first + count).
    void upload(std::uint64_t first, std::uint32_t count);
    /// Makes room for outputs of up to `bytes` and binds what the stage reads. Call before record().
    void reserve(std::uint64_t bytes, const gpu::Buffer& records, const gpu::Buffer& offsets,
                 const gpu::Buffer& patch_list, const gpu::Buffer& ring_table);
    void record(gpu::ComputePass& pass, Domain domain, std::uint32_t parameter_offset, std::uint64_t items) const;

    /// VertexAttributes of each vertex of a batch; empty until there was room to reserve.
    const gpu::Buffer& output() const { return output_; }
    std::uint64_t device_bytes() const;

    /// Bytes per patch that a job holds for the stage.
    static std::uint64_t bytes_per_patch(const patches::PatchSet& patches);

private:
    gpu::Device device_;
    const patches::PatchSet& patches_;
    const ParameterRing& parameters_;
    gpu::Buffer corners_, output_;
    std::array<Stage, 2> stages_;  // triangles, quads
};

}  // namespace tessera
