// The same job on several devices in step, every stage's buffer compared bit by bit with the first device's.
#pragma once

#include "tessellate/hair_job.hpp"
#include "tessellate/job.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tessera::verify {

/// The first word of a stage that differs.
struct Difference {
    std::uint64_t element = 0;  ///< word of the stage's output, counted over the whole job
    std::uint32_t expected = 0, found = 0;
    bool is_float = false;
};

/// One stage on one device against the first device.
struct StageComparison {
    std::uint64_t words = 0;      ///< compared
    std::uint64_t differing = 0;  ///< words that differ, or that are floats and not finite
    std::optional<Difference> first;
};

struct DeviceComparison {
    gpu::DeviceInfo device;
    std::array<StageComparison, stage_count> stages;

    bool equal() const;
};

/// Runs the job on `devices` (the first is what the others are held against; one result per device, the first one's
/// tells non-finite values only). Outputs are filled beforehand with a different word on every device, so that an
/// element left unwritten differs. `progress` (may be empty) is called with the fraction done.
std::vector<DeviceComparison> compare_jobs(const std::vector<gpu::Device>& devices, const patches::PatchSet& patches,
                                           const TessellationOptions& options,
                                           const std::function<void(double)>& progress = {});

/// The same for a job of hair; what is called control nets are the curves of the guides.
std::vector<DeviceComparison> compare_hair_jobs(const std::vector<gpu::Device>& devices, const patches::HairSet& hair,
                                                const HairOptions& options,
                                                const std::function<void(double)>& progress = {});

/// "element 12: 3f800000 (1) expected, 3f800001 (1.0000001) found"
std::string describe(const Difference& difference);

}  // namespace tessera::verify
