// A receiver of tessellation output that sees it patch by patch.
#pragma once

#include "patches/hair.hpp"
#include "patches/patches.hpp"
#include "tessellate/refined_mesh.hpp"
#include "views/patch_domain.hpp"

#include <optional>

namespace tessera::views {

/// The domains of a job's patches, in order.
class PatchDomains {
public:
    /// Both must outlive it.
    PatchDomains(const patches::PatchSet& patches, const TessellationOptions& options);

    std::uint64_t count() const { return patches_.patch_count(); }
    /// Valid until the next call.
    const PatchDomain& operator[](std::uint64_t patch);

private:
    const patches::PatchSet& patches_;
    const std::vector<PatchFactors>* per_patch_;
    Partitioning partitioning_;
    std::optional<PatchDomain> triangle_, quad_, own_;  // the first two where all patches have the same factors
};

/// The output of one patch: indices count from its first vertex.
struct PatchOutput {
    std::uint64_t patch = 0;
    std::uint32_t material = 0;
    std::uint64_t first_vertex = 0;  ///< in the whole output
    const PatchDomain& domain;
    std::span<const Vertex> vertices;
    std::span<const std::uint32_t> indices;
};

/// One run's worth: takes the output of a SceneTessellator from its first batch to its last.
class PatchSink : public MeshSink {
public:
    /// `options` and `totals` are those of the tessellator. All must outlive the sink.
    PatchSink(const patches::PatchSet& patches, const TessellationOptions& options, const MeshTotals& totals);

    void append(const MeshBatch& batch) final;

protected:
    virtual void take(const PatchOutput& output) = 0;
    /// Hair of one part, whose vertices lie at `first_vertex` of the output; indices count from there.
    virtual void take_hair(std::uint32_t material, std::uint64_t first_vertex, std::span<const Vertex> vertices,
                           std::span<const std::uint32_t> indices) = 0;

private:
    void take_hair_of(const MeshBatch& batch);

    const patches::PatchSet& patches_;
    const MeshTotals& totals_;
    PatchDomains domains_;
    std::uint64_t next_ = 0;  // patch
    std::size_t range_ = 0;   // that it lies in
    std::vector<std::uint32_t> local_;
};

}  // namespace tessera::views
