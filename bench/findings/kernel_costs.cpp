#include "kernel_costs.hpp"

#include "gpu/kernel_catalog.hpp"
#include "layout.h"

#include <fmt/format.h>

namespace tessera::findings {
namespace {

std::string net_kernel(Scheme scheme, Normals normals, Domain domain) {
    // True normals come from the positions' net; it carries linear ones for where the derivatives vanish.
    const Normals stored = normals == Normals::surface ? Normals::linear : normals;
    return fmt::format("control_net_{}_{}_{}", name(scheme), name(stored), name(domain));
}

std::string vertices_kernel(Scheme scheme, Normals normals, Domain domain) {
    constexpr const char* degrees[] = {"linear", "quadratic", "cubic"};
    return fmt::format("vertices_{}_{}_{}_shared", degrees[degree(scheme) - 1], name(normals), name(domain));
}

measure::FloatOperations count(const std::string& kernel, const char* function = "main") {
    return measure::count_float_operations(gpu::find_kernel(kernel).spirv, function);
}

std::uint32_t normal_degree(Normals normals) {
    return normals == Normals::quadratic ? 2 : 1;
}

}  // namespace

KernelCosts triangle_costs(Scheme scheme, Normals normals) {
    const std::string vertices = vertices_kernel(scheme, normals, Domain::triangle);
    const std::uint32_t degree = tessera::degree(scheme);
    KernelCosts costs;
    costs.net = count(net_kernel(scheme, normals, Domain::triangle));
    costs.vertex = count(vertices);
    costs.rest =
        count(vertices, "make_barycentric") + count(vertices, "blend_linear") + count(vertices, "blend_linear");
    costs.position = degree == 1   ? count(vertices, "evaluate_linear")
                     : degree == 2 ? count(vertices, "quadratic_weights") + count(vertices, "evaluate_quadratic")
                                   : count(vertices, "cubic_weights") + count(vertices, "evaluate_cubic");
    costs.net_bytes = sizeof(float) * NET_FLOATS(degree, normal_degree(normals));
    return costs;
}

KernelCosts quad_costs(Scheme scheme, Normals normals) {
    KernelCosts costs;
    costs.net = count(net_kernel(scheme, normals, Domain::quad));
    costs.vertex = count(vertices_kernel(scheme, normals, Domain::quad));
    costs.net_bytes = sizeof(float) * QUAD_NET_FLOATS(degree(scheme), normal_degree(normals));
    return costs;
}

}  // namespace tessera::findings
