#include "tessellate/hair_tessellator.hpp"

#include "base/error.hpp"
#include "tessellate/device_batch.hpp"
#include "tessellate/host_batch.hpp"
#include "tessellate/mesh_parts.hpp"

#include <fmt/format.h>
#include <cassert>

namespace tessera {

HairTessellator::HairTessellator(const gpu::Device& device, const patches::HairSet& hair, const HairOptions& options)
    : device_(device), hair_(hair), job_(device, hair, options, device.limits()) {
    for (const patches::PatchRange& range : hair.ranges)
        totals_.parts.push_back({range.name, range.material});
    for (std::size_t i = 0; i < job_.chunk_count(); ++i) {
        add_to_parts(totals_, hair.ranges, job_.parts_per_patch(), job_.chunk(i), job_.count(i));
        counted_chunk_ = i;
    }
    place_parts(totals_);
}

void HairTessellator::run(MeshSink& sink, std::uint64_t first_vertex, std::uint64_t first_index, Space space,
                          const std::function<void(double)>& progress) {
    const std::uint64_t end = first_vertex + totals_.vertex_count;
    if (end > 0xffffffffull) {
        throw Error(ErrorKind::usage, fmt::format("The output would have {} vertices, more than the 4294967295 that "
                                                  "32-bit indices can address; ask for fewer hairs or segments.",
                                                  end));
    }
    HostBatch host;
    std::uint64_t done = 0;
    for (std::size_t i = 0; i < job_.chunk_count(); ++i) {
        if (counted_chunk_ != i) {
            job_.count(i);
            counted_chunk_ = i;
        }
        for (const Batch& batch : job_.prepare()) {
            job_.emit(batch, static_cast<std::uint32_t>(first_vertex));
            const std::vector<StageView> views = job_.emitted_views();
            if (space != Space::kernel || !offer(sink, device_, views, batch, first_vertex, first_index)) {
                host.read(device_, views);
                if (space == Space::model) scale_to_model(host.vertices, hair_.exponent);
                sink.append({first_vertex, first_index, host.vertices, host.indices});
            }
            first_vertex += batch.vertex_count;
            first_index += batch.index_count;
            done += batch.vertex_count;
            if (progress) progress(static_cast<double>(done) / static_cast<double>(totals_.vertex_count));
        }
    }
    assert(first_vertex == end);
}

RefinedMesh tessellate_hair(const gpu::Device& device, const patches::HairSet& hair, const HairOptions& options) {
    HairTessellator tessellator(device, hair, options);
    RefinedMesh mesh;
    mesh.parts = tessellator.totals().parts;
    tessellator.run(mesh);
    return mesh;
}

}  // namespace tessera
