// tessera verify --oracle: the kernels against a device's own tessellation stage.
#pragma once

#include "cli/command.hpp"
#include "cli/job_options.hpp"
#include "cli/load.hpp"

#include <string>
#include <vector>

namespace tessera::cli {

struct OracleWords {
    std::vector<std::string> inputs;
    std::vector<std::string> devices;  ///< that run the kernels
    LoadWords load;
    std::vector<JobWords> jobs;
    bool skip_unsupported = false;  ///< jobs that the stage has no spacing for: skipped with a message, else an error
    bool json = false;
};

/// Holds every job on every input against the first tessellation stage that can be captured, and prints what was found.
/// Returns the exit code. Throws Error(device_unavailable) where there is no such stage.
int verify_with_oracle(const Context& context, const OracleWords& words);

}  // namespace tessera::cli
