// Memory traffic: what goes to a device per frame for a coarse mesh that is refined there, and for the refined mesh.
#pragma once

#include "bench/contest.hpp"
#include "bench/report.hpp"
#include "bench/workload.hpp"
#include "gpu/device.hpp"

namespace tessera::bench {

/// A row per device for the workload. A frame of the coarse mesh uploads all its control vertices (it is animated),
/// patches and factors, and tessellates; a frame of the refined mesh uploads vertices and indices. Both are measured.
void measure_upload(Table& table, const std::vector<gpu::Device>& devices, const Workload& workload,
                    const Effort& effort);

/// The table without rows.
Table upload_table();

}  // namespace tessera::bench
