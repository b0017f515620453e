// What memory takes at most: the roof over everything that writes vertices.
#pragma once

#include "base/host_memory.hpp"
#include "bench/contest.hpp"
#include "bench/sanity.hpp"
#include "gpu/device.hpp"

#include <cstdint>

namespace tessera::bench {

/// Memory of the host, written and copied by all threads.
class HostRoofs {
public:
    /// `bytes` per buffer, rounded up to whole blocks of 1 MiB.
    explicit HostRoofs(std::uint64_t bytes);

    void write_plain();
    void write_streaming();  ///< non-temporal stores
    void copy();
    std::uint64_t bytes() const { return bytes_; }

    /// Adds "write, plain", "write, non-temporal" and "copy"; the roofs must outlive them.
    void add_to(std::vector<Contestant>& contestants);

private:
    std::uint64_t bytes_;
    HostMemory first_, second_;
    std::uint32_t word_ = 1;
};

/// Memory of a device, filled by its own command.
class FillRoof {
public:
    FillRoof(const gpu::Device& device, std::uint64_t bytes);
    void fill();
    std::uint64_t bytes() const { return buffer_.size(); }

private:
    gpu::Device device_;
    gpu::Buffer buffer_;
};

/// Hardware threads that the roofs and the parallel peers use.
unsigned thread_count();

}  // namespace tessera::bench
