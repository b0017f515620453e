// W5: the tables of Nunes et al., "Analysis and Implementation of Local Subdivision Algorithms in the GPU", 2011: a
// scene of many copies of one small model, Phong tessellation against PN triangles.
#pragma once

#include "bench/contest.hpp"
#include "bench/rasterisers.hpp"
#include "bench/report.hpp"
#include "bench/workload.hpp"

namespace tessera::bench {

/// Two tables: Fox for their tiger, RiggedFigure for their person. As there, PN has quadratic normals and Phong linear
/// ones. Throws Error(usage) where a model cannot be read.
std::vector<Table> measure_copies(const std::vector<gpu::Device>& devices, const WorkloadSource& source,
                                  const Effort& effort, const Rasterisers& rasterisers);

}  // namespace tessera::bench
