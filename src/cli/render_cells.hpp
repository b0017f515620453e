// The surfaces that a picture of render shows side by side.
#pragma once

#include "cli/job_options.hpp"
#include "views/view.hpp"

#include <string>
#include <vector>

namespace tessera::cli {

/// A cell for each of `compare`, "SCHEME" or "SCHEME:NORMALS", or the job's own where there is none. Labels name the
/// scheme, and the normals where they were given. Throws Error(usage) for words that make no sense.
std::vector<views::Cell> make_cells(const JobWords& job, const std::vector<std::string>& compare,
                                    const views::Subject& subject);

}  // namespace tessera::cli
