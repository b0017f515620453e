// OpenSubdiv's evaluator on all threads: other work (limit surfaces of Loop subdivision with first derivatives, no
// triangles), on as many points, for a sense of scale.
#pragma once

#include "bench/peer.hpp"

namespace tessera::peers {

inline constexpr const char* opensubdiv_peer = "OpenSubdiv (other work)";

/// Does workloads of triangles with one factor of 2 or more for all and at most 100,000 patches. Throws Error(usage)
/// for a mesh that OpenSubdiv does not take.
std::unique_ptr<bench::Peer> make_opensubdiv(const bench::Workload& workload);

}  // namespace tessera::peers
