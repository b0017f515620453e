// Holds a stream of batches against the totals announced for it, so that no writer makes an unsound file.
#pragma once

#include "tessellate/refined_mesh.hpp"

#include <algorithm>

namespace tessera::exporting {

/// Follows the batches of one output. What contradicts the totals is a mistake of the caller and throws
/// std::logic_error; a vertex that is not finite is data and throws Error(output).
class BatchCheck {
public:
    /// Requires parts that cover the totals one after another, in whole triangles. `file` is used in messages.
    BatchCheck(const MeshTotals& totals, std::string file);

    /// Requires that `batch` continues the one before, stays within the totals, uses its own vertices only and no
    /// vertices of another part, marks as quads only pairs of triangles that are halves of one, has tangents and
    /// attributes where the totals say so, and holds finite numbers.
    void accept(const MeshBatch& batch);

    /// Requires that everything announced has come.
    void finish() const;

    const MeshTotals& totals() const { return totals_; }

private:
    void check_indices(const MeshBatch& batch) const;
    void check_finite(const MeshBatch& batch) const;
    void check_quads(const MeshBatch& batch) const;

    MeshTotals totals_;
    std::string file_;
    std::uint64_t vertices_ = 0;
    std::uint64_t indices_ = 0;
};

/// Calls visit(part number, first, count) for the stretch of each part within [first, first + count), in order;
/// `first_of` and `count_of` choose vertices or indices.
template <typename Visit>
void for_each_part(const MeshTotals& totals, std::uint64_t MeshPart::*first_of, std::uint64_t MeshPart::*count_of,
                   std::uint64_t first, std::uint64_t count, Visit visit) {
    const auto end_of = [&](const MeshPart& part) { return part.*first_of + part.*count_of; };
    const auto begin = std::partition_point(totals.parts.begin(), totals.parts.end(),
                                            [&](const MeshPart& part) { return end_of(part) <= first; });
    for (auto part = begin; part != totals.parts.end() && (*part).*first_of < first + count; ++part) {
        const std::uint64_t from = std::max(first, (*part).*first_of);
        const std::uint64_t to = std::min(first + count, end_of(*part));
        if (from < to) visit(static_cast<std::size_t>(part - totals.parts.begin()), from, to - from);
    }
}

}  // namespace tessera::exporting
