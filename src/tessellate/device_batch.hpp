// Offers what a job has emitted to a sink before it is read back.
#pragma once

#include "tessellate/job.hpp"
#include "tessellate/refined_mesh.hpp"

namespace tessera {

/// True where the sink took the batch from the device. `views` are those of Job::emitted_views (or HairJob's), the
/// firsts count within the whole output.
bool offer(MeshSink& sink, const gpu::Device& device, const std::vector<StageView>& views, const Batch& batch,
           std::uint64_t first_vertex, std::uint64_t first_index);

}  // namespace tessera
