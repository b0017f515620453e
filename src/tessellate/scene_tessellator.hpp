// Surfaces and hair of one scene as one output: first what the meshes become, then the ribbons.
#pragma once

#include "tessellate/hair_tessellator.hpp"

#include <optional>

namespace tessera {

class SceneTessellator {
public:
    /// Counts the output. `patches` and `hair` are of one scene; either may be empty, and where neither is, each gets
    /// half of its memory budget. Device, patches and hair must outlive the tessellator. Throws like Tessellator and
    /// HairTessellator, and Error(usage) where tangents are asked for and there is hair, which has none.
    SceneTessellator(const gpu::Device& device, const patches::PatchSet& patches, const TessellationOptions& options,
                     const patches::HairSet& hair, const HairOptions& hair_options);

    /// The parts of the meshes, then those of the guides.
    const MeshTotals& totals() const { return totals_; }
    bool has_hair() const { return hair_.has_value(); }
    /// See HairTessellator::face; nothing where there is no hair.
    void face(const glm::vec3& eye);
    void run(MeshSink& sink, Space space = Space::model, const std::function<void(double)>& progress = {});

    /// Of both, added up.
    StageTimes times();
    std::uint64_t device_bytes() const;

private:
    std::optional<Tessellator> surface_;
    std::optional<HairTessellator> hair_;
    MeshTotals totals_;
};

}  // namespace tessera
