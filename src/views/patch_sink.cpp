#include "views/patch_sink.hpp"

#include <algorithm>
#include <cassert>

namespace tessera::views {
namespace {

Domain domain_of(const patches::PatchCorners& corners) {
    return patches::is_quad(corners) ? Domain::quad : Domain::triangle;
}

}  // namespace

PatchDomains::PatchDomains(const patches::PatchSet& patches, const TessellationOptions& options)
    : patches_(patches),
      per_patch_(std::get_if<std::vector<PatchFactors>>(&options.factors)),
      partitioning_(options.partitioning) {
    if (const auto* const all = std::get_if<PatchFactors>(&options.factors)) {
        triangle_.emplace(Domain::triangle, partitioning_, *all);
        quad_.emplace(Domain::quad, partitioning_, *all);
    }
}

const PatchDomain& PatchDomains::operator[](std::uint64_t patch) {
    const Domain domain = domain_of(patches_.corners[patch]);
    if (per_patch_ == nullptr) return domain == Domain::quad ? *quad_ : *triangle_;
    return own_.emplace(domain, partitioning_, (*per_patch_)[patch]);
}

PatchSink::PatchSink(const patches::PatchSet& patches, const TessellationOptions& options, const MeshTotals& totals)
    : patches_(patches), totals_(totals), domains_(patches, options) {}

void PatchSink::append(const MeshBatch& batch) {
    std::size_t vertex = 0, index = 0;
    while (vertex < batch.vertices.size() && next_ < domains_.count()) {
        const PatchDomain& domain = domains_[next_];
        assert(vertex + domain.vertex_count() <= batch.vertices.size());
        assert(index + domain.index_count() <= batch.indices.size());
        while (next_ >= patches_.ranges[range_].first_patch + patches_.ranges[range_].patch_count)
            ++range_;
        const std::span<const std::uint32_t> indices = batch.indices.subspan(index, domain.index_count());
        local_.resize(indices.size());
        std::ranges::transform(indices, local_.begin(), [&](std::uint32_t i) {
            return static_cast<std::uint32_t>(i - (batch.first_vertex + vertex));
        });
        if (!indices.empty()) {
            take({next_, patches_.ranges[range_].material, batch.first_vertex + vertex, domain,
                  batch.vertices.subspan(vertex, domain.vertex_count()), local_});
        }
        vertex += domain.vertex_count();
        index += domain.index_count();
        ++next_;
    }
    // A batch is of the surface or of hair.
    if (vertex == 0) take_hair_of(batch);
}

void PatchSink::take_hair_of(const MeshBatch& batch) {
    const std::uint64_t batch_end = batch.first_index + batch.indices.size();
    for (const MeshPart& part : totals_.parts) {
        const std::uint64_t first = std::max(part.first_index, batch.first_index);
        const std::uint64_t end = std::min(part.first_index + part.index_count, batch_end);
        if (first >= end) continue;
        const std::uint64_t from = std::max(part.first_vertex, batch.first_vertex);
        const std::uint64_t to =
            std::min(part.first_vertex + part.vertex_count, batch.first_vertex + batch.vertices.size());
        const std::span<const std::uint32_t> indices = batch.indices.subspan(first - batch.first_index, end - first);
        local_.resize(indices.size());
        std::ranges::transform(indices, local_.begin(),
                               [&](std::uint32_t i) { return static_cast<std::uint32_t>(i - from); });
        take_hair(part.material, from, batch.vertices.subspan(from - batch.first_vertex, to - from), local_);
    }
}

}  // namespace tessera::views
