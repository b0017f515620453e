// Builds the catalog: what slots a kernel has is read from its C++ signature, and the loop of the reference backend is
// made from the same function, so that a kernel is declared in one place only.
#include "gpu/kernel_catalog.hpp"

#include "base/error.hpp"
#include "embedded.hpp"
#include "kernel_includes.inc"  // generated: #include "stages/NAME.h" for every kernel

#include <fmt/format.h>
#include <algorithm>
#include <tuple>
#include <utility>

namespace tessera::gpu {
namespace {

template <typename Parameter>
struct Slot;
template <unsigned N, typename T>
struct Slot<kernels::Read<N, T>> {
    static constexpr KernelBinding binding{N, BindingKind::read_storage, sizeof(T)};
    static kernels::Read<N, T> bind(std::byte* memory) { return {reinterpret_cast<const T*>(memory)}; }
};
template <unsigned N, typename T>
struct Slot<kernels::Write<N, T>> {
    static constexpr KernelBinding binding{N, BindingKind::write_storage, sizeof(T)};
    static kernels::Write<N, T> bind(std::byte* memory) { return {reinterpret_cast<T*>(memory)}; }
};
template <unsigned N, typename T>
struct Slot<kernels::Uniform<N, T>> {
    static constexpr KernelBinding binding{N, BindingKind::uniform, sizeof(T)};
    static kernels::Uniform<N, T> bind(std::byte* memory) { return {reinterpret_cast<const T*>(memory)}; }
};

template <auto Function>
struct Wrap;
template <typename... Parameters, void (*Function)(kernels::Item, Parameters...)>
struct Wrap<Function> {
    static Kernel describe(const char* name) {
        Kernel kernel{
            name, {Slot<Parameters>::binding...}, kernels::embedded_spirv(name), kernels::embedded_opencl(name), &run};
        return kernel;
    }

    static void run(std::uint32_t first_item, std::uint32_t last_item, std::byte* const* slots) {
        const std::tuple<Parameters...> bound{Slot<Parameters>::bind(slots[Slot<Parameters>::binding.slot])...};
        for (std::uint32_t item = first_item; item < last_item; ++item) {
            std::apply([item](const Parameters&... parameters) { Function(kernels::Item{item}, parameters...); },
                       bound);
        }
    }
};

std::vector<Kernel> make_catalog() {
    std::vector<Kernel> catalog;
#define KERNEL(name) catalog.push_back(Wrap<&kernels::name>::describe(#name));
#include "kernel_names.inc"  // generated: KERNEL(NAME) for every kernel
#undef KERNEL
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

const Kernel& find_kernel(std::string_view name) {
    const auto found = std::ranges::lower_bound(catalog(), name, {}, &Kernel::name);
    if (found == catalog().end() || found->name != name) {
        throw Error(ErrorKind::usage,
                    fmt::format("There is no kernel named \"{}\"; kernels/stages has them all.", name));
    }
    return *found;
}

}  // namespace tessera::gpu
