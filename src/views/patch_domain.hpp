// The domain of one patch on the host: what its factors become, and its points in the order of its vertices.
#pragma once

#include "tessellate/options.hpp"
#include "tessellate/pattern.hpp"

#include <cstdint>
#include <vector>

namespace tessera::views {

/// What the pipeline's first and third stage know of a patch, and the domain points of its fifth, by the same code.
class PatchDomain {
public:
    /// `domain` is triangle or quad.
    PatchDomain(Domain domain, Partitioning partitioning, const PatchFactors& factors);

    Domain domain() const { return domain_; }
    /// Both 0 for a culled patch.
    std::uint32_t vertex_count() const { return vertices_; }
    std::uint32_t index_count() const { return indices_; }
    /// Factors as the tessellator uses them, clamped and rounded as the partitioning asks, in the order of
    /// PatchFactors; all alike with Partitioning::uniform. Zeros for a culled patch.
    const PatchFactors& factors() const { return factors_; }
    std::vector<DomainPoint> points() const;

private:
    Domain domain_;
    std::uint32_t record_[8];
    std::uint32_t vertices_ = 0, indices_ = 0;
    PatchFactors factors_{};
};

}  // namespace tessera::views
