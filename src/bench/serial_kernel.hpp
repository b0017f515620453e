// The serial one-patch-per-item kernel as a peer: the whole job, with its emission instead of ours.
#pragma once

#include "bench/peer.hpp"

namespace tessera::bench {

/// Does workloads of PN triangles with quadratic normals. Named serial_peer_prefix and the device's id.
PeerMaker serial_kernel_peer(const gpu::Device& device);

}  // namespace tessera::bench
