// What is tessellated for a measurement.
#pragma once

#include "patches/patches.hpp"
#include "tessellate/options.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tessera::bench {

struct Workload {
    std::string id;           ///< "W1"
    std::string description;  ///< a phrase for people
    patches::PatchSet patches;
    TessellationOptions options;
    /// Every patch has the same factor, and it is this one.
    std::optional<float> uniform_factor;
};

/// Where the models of the larger workloads lie; empty where nowhere. `quick` makes everything about a hundredth.
struct WorkloadSource {
    std::filesystem::path models;
    bool quick = false;
};

/// The one-job workloads, made when asked for:
///   W1  20,000 PN triangles (shape:sphere:50), factor 16, integer
///   W1-64  the same at factor 64, for GPUs
///   W2  the same, random factors 1..64 per edge, fractional_odd
///   W3  HugeSpot at factor 4;  W3-1  at factor 1
///   W4  rook as quads at factor 32
/// Throws Error(usage) for another name and where the model cannot be read.
Workload make_workload(const std::string& id, const WorkloadSource& source);

/// Names in the order of the report.
std::vector<std::string> job_workloads();

/// Six equal factors.
PatchFactors equal_factors(float factor);

}  // namespace tessera::bench
