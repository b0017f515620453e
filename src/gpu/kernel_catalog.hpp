// Every kernel of the project by name, in each of its forms. The table is made by the build from kernels/stages.
#pragma once

#include "gpu/types.hpp"

namespace tessera::gpu {

/// All kernels, sorted by name.
std::span<const Kernel> all_kernels();

/// The kernel called `name` (the stem of its file in kernels/stages). Throws Error(usage) for an unknown name.
const Kernel& find_kernel(std::string_view name);

}  // namespace tessera::gpu
