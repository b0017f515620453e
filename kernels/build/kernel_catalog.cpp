// Builds the catalog: every kernel's name, bindings and three forms.
#include "gpu/kernel_catalog.hpp"

#include "base/error.hpp"
#include "embedded.hpp"
#include "reference_kernels.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cstdlib>

namespace tessera::gpu {
namespace {

struct InstructionSet {
    std::string_view name;
    bool usable;
    std::vector<kernels::ReferenceKernel> (*kernels)();
};

// From narrow to wide.
std::vector<InstructionSet> instruction_sets() {
    std::vector<InstructionSet> sets{{"baseline", true, kernels::reference_kernels_baseline}};
#ifdef TESSERA_X86_KERNELS
    __builtin_cpu_init();
    const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    sets.push_back({"avx2", __builtin_cpu_supports("avx2") != 0, kernels::reference_kernels_avx2});
    sets.push_back({"avx512", avx512, kernels::reference_kernels_avx512});
#endif
    return sets;
}

InstructionSet choose_instruction_set() {
    const std::vector<InstructionSet> sets = instruction_sets();
    const char* wanted = std::getenv("TESSERA_REFERENCE_ISA");
    const InstructionSet* best = nullptr;
    for (const InstructionSet& set : sets) {
        if (set.usable && (wanted == nullptr || set.name == wanted)) {
            best = &set;
        }
    }
    if (best == nullptr) {
        throw Error(ErrorKind::usage,
                    fmt::format("TESSERA_REFERENCE_ISA asks for \"{}\", which this build or processor does not have; "
                                "unset it, or use baseline, avx2 or avx512.",
                                wanted));
    }
    return *best;
}

const InstructionSet& instruction_set() {
    static const InstructionSet chosen = choose_instruction_set();
    return chosen;
}

std::vector<Kernel> make_catalog() {
    std::vector<Kernel> catalog;
    for (kernels::ReferenceKernel& kernel : instruction_set().kernels()) {
        catalog.push_back({kernel.name, std::move(kernel.bindings), kernels::embedded_spirv(kernel.name),
                           kernels::embedded_opencl(kernel.name), kernel.run});
    }
    std::ranges::sort(catalog, {}, &Kernel::name);
    return catalog;
}

const std::vector<Kernel>& catalog() {
    static const std::vector<Kernel> kernels = make_catalog();
    return kernels;
}

}  // namespace

std::span<const Kernel> all_kernels() {
    return catalog();
}

std::string_view reference_instruction_set() {
    return instruction_set().name;
}

const Kernel& find_kernel(std::string_view name) {
    const auto found = std::ranges::lower_bound(catalog(), name, {}, &Kernel::name);
    if (found == catalog().end() || found->name != name) {
        throw Error(ErrorKind::usage,
                    fmt::format("There is no kernel named \"{}\"; kernels/stages has them all.", name));
    }
    return *found;
}

}  // namespace tessera::gpu
