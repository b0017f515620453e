// The C++ form of every kernel. The same source is compiled once per instruction set, and the processor at hand
// chooses.
#pragma once

#include "gpu/types.hpp"

#include <string_view>
#include <vector>

namespace tessera::kernels {

struct ReferenceKernel {
    const char* name;
    std::vector<gpu::KernelBinding> bindings;
    void (*run)(std::uint32_t first_item, std::uint32_t last_item, std::byte* const* slots);
};

std::vector<ReferenceKernel> reference_kernels_baseline();
std::vector<ReferenceKernel> reference_kernels_avx2();    // where the build has it: TESSERA_X86_KERNELS
std::vector<ReferenceKernel> reference_kernels_avx512();  // likewise

}  // namespace tessera::kernels
