// Others that do the same work, timed beside our kernels.
#pragma once

#include "bench/job_run.hpp"
#include "bench/workload.hpp"

#include <functional>
#include <memory>
#include <string>

namespace tessera::bench {

/// A peer made ready for one workload: memory taken, pipelines built.
class Peer {
public:
    virtual ~Peer() = default;
    /// Does the work once and returns when it is done.
    virtual void run() = 0;
    /// What one run makes.
    virtual OutputSize size() const = 0;
    /// Bytes that one run writes.
    virtual std::uint64_t bytes() const { return size().bytes(); }
    /// Times of a run are multiplied by this: the part of the workload that one run does not do.
    virtual double scale() const { return 1.0; }
    /// Looks at the output of a run. A sentence where it is not what was asked for, else empty.
    virtual std::string check() { return {}; }
    /// A phrase for the report: what differs from our own work.
    virtual std::string note() const { return {}; }
};

/// Makes a peer for workloads. `make` returns null for workloads that the peer does not do, and throws Error where it
/// cannot here.
struct PeerMaker {
    std::string name;
    std::function<std::unique_ptr<Peer>(const Workload&)> make;
    bool on_host = true;  ///< bound by the host's memory roof
};

}  // namespace tessera::bench
