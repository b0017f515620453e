// W5: the tables of Nunes et al., "Analysis and Implementation of Local Subdivision Algorithms in the GPU", 2011: a
// scene of many copies of one small model, Phong tessellation against PN triangles.
#pragma once

#include "bench/contest.hpp"
#include "bench/report.hpp"
#include "bench/workload.hpp"
#include "gpu/device.hpp"
#include "render/rasteriser.hpp"

#include <functional>
#include <memory>

namespace tessera::bench {

/// Opens what draws for a device; null where nothing does.
using OpenRasteriser = std::function<std::unique_ptr<render::Rasteriser>(const std::string& device)>;

/// Two tables: Fox for their tiger, RiggedFigure for their person. As there, PN has quadratic normals and Phong linear
/// ones. Throws Error(usage) where a model cannot be read.
std::vector<Table> measure_copies(const std::vector<gpu::Device>& devices, const WorkloadSource& source,
                                  const Effort& effort, const OpenRasteriser& open_rasteriser);

}  // namespace tessera::bench
