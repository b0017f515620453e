// The peers of `tessera bench` that run on the host.
#pragma once

#include "bench/peer.hpp"
#include "bench/report.hpp"

#include <vector>

namespace tessera::peers {

/// The peers that were built in.
std::vector<bench::PeerMaker> host_peers();

/// Those that were not, and why.
std::vector<bench::Missing> peers_not_built();

}  // namespace tessera::peers
