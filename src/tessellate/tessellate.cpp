#include "tessellate/tessellate.hpp"

#include "base/error.hpp"
#include "layout.h"
#include "tessellate/device_batch.hpp"
#include "tessellate/host_batch.hpp"
#include "tessellate/mesh_parts.hpp"
#include "tessellate/quad_faces.hpp"

#include <fmt/format.h>
#include <cassert>

namespace tessera {
namespace {

/// Marks the quads of a batch whose first vertex has the index `first_vertex`.
void mark_batch(const Batch& batch, const std::vector<PatchOffset>& offsets, std::span<const std::uint32_t> records,
                std::uint32_t first_vertex, std::span<std::uint32_t> indices, std::vector<std::uint8_t>& quads) {
    quads.assign(indices.size() / 3, 0);
    for (std::size_t p = batch.first_patch; p < std::size_t{batch.first_patch} + batch.patch_count; ++p) {
        const std::size_t start = offsets[p].index - batch.first_index;
        const std::size_t count = offsets[p + 1].index - offsets[p].index;
        mark_quads(RecordView(records.subspan(p * RECORD_WORDS, RECORD_WORDS)),
                   first_vertex + (offsets[p].vertex - batch.first_vertex), indices.subspan(start, count),
                   std::span(quads).subspan(start / 3, count / 3));
    }
}

}  // namespace

Tessellator::Tessellator(const gpu::Device& device, const patches::PatchSet& patches,
                         const TessellationOptions& options)
    : device_(device), patches_(patches), job_(device, patches, options, device.limits()) {
    for (const patches::PatchRange& range : patches.ranges) {
        totals_.parts.push_back({range.name, range.material});
    }
    for (std::size_t i = 0; i < job_.chunk_count(); ++i) {
        add_to_parts(totals_, patches.ranges, 1, job_.chunk(i), job_.count(i));
        counted_chunk_ = i;
    }
    place_parts(totals_);
    marks_quads_ = options.topology == Topology::quads;
    totals_.has_quads = marks_quads_;
    totals_.has_tangents = options.tangents != Tangents::none;
    totals_.has_attributes = !patches.corner_attributes.empty();
    totals_.has_colors = patches.has_colors;
}

std::vector<std::uint32_t> Tessellator::read_records() {
    const StageView view = job_.prepared_views().front();
    assert(view.stage == StageId::factors);
    std::vector<std::uint32_t> records(view.bytes / 4);
    device_.queue().read_buffer(view.buffer, 0, std::as_writable_bytes(std::span(records)));
    return records;
}

void Tessellator::run(MeshSink& sink, Space space, const std::function<void(double)>& progress) {
    if (totals_.vertex_count > 0xffffffffull) {
        throw Error(ErrorKind::usage, fmt::format("The output would have {} vertices, more than the 4294967295 that "
                                                  "32-bit indices can address; use smaller factors.",
                                                  totals_.vertex_count));
    }
    HostBatch host;
    std::vector<std::uint32_t> records;
    std::vector<std::uint8_t> quads;
    std::uint64_t first_vertex = 0;
    std::uint64_t first_index = 0;
    for (std::size_t i = 0; i < job_.chunk_count(); ++i) {
        if (counted_chunk_ != i) {
            job_.count(i);
            counted_chunk_ = i;
        }
        if (marks_quads_) records = read_records();
        for (const Batch& batch : job_.prepare()) {
            job_.emit(batch, static_cast<std::uint32_t>(first_vertex));
            const std::vector<StageView> views = job_.emitted_views();
            if (space != Space::kernel || !offer(sink, device_, views, batch, first_vertex, first_index)) {
                host.read(device_, views);
                if (space == Space::model) scale_to_model(host.vertices, patches_.exponent);
                if (marks_quads_) {
                    mark_batch(batch, job_.offsets(), records, static_cast<std::uint32_t>(first_vertex), host.indices,
                               quads);
                }
                sink.append(
                    {first_vertex, first_index, host.vertices, host.indices, quads, host.tangents, host.attributes});
            }
            first_vertex += batch.vertex_count;
            first_index += batch.index_count;
            if (progress) {
                progress(static_cast<double>(first_vertex) / static_cast<double>(totals_.vertex_count));
            }
        }
    }
    assert(first_vertex == totals_.vertex_count && first_index == totals_.index_count);
}

void RefinedMesh::append(const MeshBatch& batch) {
    vertices.insert(vertices.end(), batch.vertices.begin(), batch.vertices.end());
    indices.insert(indices.end(), batch.indices.begin(), batch.indices.end());
    tangents.insert(tangents.end(), batch.tangents.begin(), batch.tangents.end());
    attributes.insert(attributes.end(), batch.attributes.begin(), batch.attributes.end());
}

RefinedMesh tessellate(const gpu::Device& device, const patches::PatchSet& patches,
                       const TessellationOptions& options) {
    Tessellator tessellator(device, patches, options);
    RefinedMesh mesh;
    mesh.vertices.reserve(tessellator.totals().vertex_count);
    mesh.indices.reserve(tessellator.totals().index_count);
    mesh.tangents.reserve(tessellator.totals().has_tangents ? tessellator.totals().vertex_count : 0);
    mesh.attributes.reserve(tessellator.totals().has_attributes ? tessellator.totals().vertex_count : 0);
    mesh.parts = tessellator.totals().parts;
    tessellator.run(mesh);
    return mesh;
}

}  // namespace tessera
