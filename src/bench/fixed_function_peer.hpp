// A device's tessellation stage as three peers: captured, discarded, drawn.
#pragma once

#include "bench/peer.hpp"
#include "bench/timed_draw.hpp"

namespace tessera::bench {

/// They do workloads of PN triangles with quadratic normals. A stage in software gets every tenth patch of a large
/// workload, in draws of 100: longer ones slow lavapipe down out of proportion; its times are scaled up. A GPU gets all
/// patches in one draw.
std::vector<PeerMaker> fixed_function_peers(std::shared_ptr<TimedStage> stage);

}  // namespace tessera::bench
