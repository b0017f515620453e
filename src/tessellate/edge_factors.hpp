// Tessellation factors per edge that neighbouring patches agree on.
#pragma once

#include "patches/patches.hpp"
#include "tessellate/options.hpp"

#include <cstdint>
#include <vector>

namespace tessera {

/// Pseudo-random factors in [least, greatest] for every edge, the same for all patches that share it (edges are told by
/// the positions of their ends, so that seams agree too) and the same for the same seed on every machine; inside
/// factors are random per patch. For tests of watertightness and for `verify`.
std::vector<PatchFactors> random_edge_factors(const patches::PatchSet& patches, float least, float greatest,
                                              std::uint64_t seed);

}  // namespace tessera
