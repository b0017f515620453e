// The whole bench: every workload on every device beside every peer, in one run.
#pragma once

#include "bench/contest.hpp"
#include "bench/copies.hpp"
#include "bench/peer.hpp"
#include "bench/report.hpp"
#include "gpu/device.hpp"

#include <filesystem>

namespace tessera::bench {

struct Settings {
    std::vector<std::string> workloads{"W1", "W2", "W3", "W4", "W5", "W6", "W7"};
    std::vector<gpu::Device> devices;
    std::vector<PeerMaker> peers;
    WorkloadSource source;
    Effort effort;
    Rasterisers rasterisers;
    std::vector<Missing> missing;  ///< what the program was built without, for the report
};

/// `say` is told what is measured now.
Report run_bench(const Settings& settings, const std::function<void(const std::string&)>& say);

}  // namespace tessera::bench
