// Compiled once per instruction set, with TESSERA_ISA naming it. What slots a kernel has is read from its C++
// signature, and the loop of the reference backend is made from the same function, so that a kernel is declared in one
// place only.
#include "reference_kernels.hpp"

#include "kernel_includes.inc"  // generated: #include "stages/NAME.h" for every kernel

namespace tessera::kernels {
namespace TESSERA_ISA {
namespace {

template <typename Parameter>
struct Slot;
template <unsigned N, typename T>
struct Slot<Read<N, T>> {
    static constexpr gpu::KernelBinding binding{N, gpu::BindingKind::read_storage, sizeof(T)};
    static Read<N, T> bind(std::byte* const* slots) { return {reinterpret_cast<const T*>(slots[N])}; }
};
template <unsigned N, typename T>
struct Slot<Write<N, T>> {
    static constexpr gpu::KernelBinding binding{N, gpu::BindingKind::write_storage, sizeof(T)};
    static Write<N, T> bind(std::byte* const* slots) { return {reinterpret_cast<T*>(slots[N])}; }
};
template <unsigned N, typename T>
struct Slot<Uniform<N, T>> {
    static constexpr gpu::KernelBinding binding{N, gpu::BindingKind::uniform, sizeof(T)};
    static Uniform<N, T> bind(std::byte* const* slots) { return {reinterpret_cast<const T*>(slots[N])}; }
};

template <auto Function>
struct Wrap;
template <typename... Parameters, void (*Function)(Item, Parameters...)>
struct Wrap<Function> {
    static ReferenceKernel describe(const char* name) { return {name, {Slot<Parameters>::binding...}, &run}; }

    static void run(std::uint32_t first_item, std::uint32_t last_item, std::byte* const* slots) {
        for (std::uint32_t item = first_item; item < last_item; ++item) {
            Function(Item{item}, Slot<Parameters>::bind(slots)...);
        }
        end_streaming();
    }
};

}  // namespace
}  // namespace TESSERA_ISA

#define TESSERA_JOIN(a, b) a##b
#define TESSERA_FOR_ISA(isa) TESSERA_JOIN(reference_kernels_, isa)

std::vector<ReferenceKernel> TESSERA_FOR_ISA(TESSERA_ISA)() {
    std::vector<ReferenceKernel> kernels;
#define KERNEL(name) kernels.push_back(TESSERA_ISA::Wrap<&TESSERA_ISA::name>::describe(#name));
#include "kernel_names.inc"  // generated: KERNEL(NAME) for every kernel
#undef KERNEL
    return kernels;
}

}  // namespace tessera::kernels
