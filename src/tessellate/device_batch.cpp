#include "tessellate/device_batch.hpp"

namespace tessera {

bool offer(MeshSink& sink, const gpu::Device& device, const std::vector<StageView>& views, const Batch& batch,
           std::uint64_t first_vertex, std::uint64_t first_index) {
    DeviceMeshBatch offered;
    offered.device = device;
    offered.first_vertex = first_vertex;
    offered.vertex_count = batch.vertex_count;
    offered.first_index = first_index;
    offered.index_count = batch.index_count;
    for (const StageView& view : views) {
        if (view.stage == StageId::vertices) offered.vertices = view.buffer;
        if (view.stage == StageId::indices) offered.indices = view.buffer;
        if (view.stage == StageId::tangents) offered.tangents = view.buffer;
        if (view.stage == StageId::attributes) offered.attributes = view.buffer;
    }
    return sink.take_from_device(offered);
}

}  // namespace tessera
