// Every kernel of the project by name, in each of its forms. The table is made by the build from kernels/stages.
#pragma once

#include "gpu/types.hpp"

namespace tessera::gpu {

/// All kernels, sorted by name.
std::span<const Kernel> all_kernels();

/// The kernel called `name` (the stem of its file in kernels/stages). Throws Error(usage) for an unknown name.
const Kernel& find_kernel(std::string_view name);

/// The instruction set that the C++ forms of the kernels were compiled for: "baseline", "avx2" or "avx512", the widest
/// that the processor has. The environment variable TESSERA_REFERENCE_ISA asks for another; throws Error(usage) where
/// that cannot run.
std::string_view reference_instruction_set();

}  // namespace tessera::gpu
