// The best that a CPU can do by hand: PN triangles of one factor, evaluated by vectors of points with precomputed
// weights and fused multiply-adds, on all threads, with non-temporal stores. It makes the vertices and triangles of
// our kernels, in their layout and order, but not their bits.
#pragma once

#include "bench/peer.hpp"

namespace tessera::peers {

/// Does workloads of PN triangles with one factor of 2 or more for all. Throws Error(device_unavailable) where the CPU
/// has neither AVX-512 nor AVX2 with FMA.
std::unique_ptr<bench::Peer> make_hand_written(const bench::Workload& workload);

}  // namespace tessera::peers
