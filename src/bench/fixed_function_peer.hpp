// A device's tessellation stage as three peers: captured, discarded, drawn.
#pragma once

#include "bench/peer.hpp"
#include "bench/timed_draw.hpp"

namespace tessera::bench {

/// They do workloads of PN triangles with quadratic normals. A stage in software gets about 2000 patches, spread over a
/// large workload, and its times are scaled up; draws are of two patches, where lavapipe is fastest: with 100 it takes
/// five to eighty times as long. A GPU gets all patches in one draw.
std::vector<PeerMaker> fixed_function_peers(std::shared_ptr<TimedStage> stage);

}  // namespace tessera::bench
