// The counts against counts by hand.
#include "measure/float_operations.hpp"

#include "base/error.hpp"
#include "gpu/kernel_catalog.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace tessera {
namespace {

measure::FloatOperations count(const char* kernel, const char* function = "main") {
    return measure::count_float_operations(gpu::find_kernel(kernel).spirv, function);
}

TEST(FloatOperations, OfSmallFunctions) {
    const char* kernel = "vertices_cubic_quadratic_triangle_shared";
    EXPECT_EQ(count("scale_probe").additions, 1u);
    EXPECT_EQ(count("scale_probe").multiplications, 1u);
    EXPECT_EQ(count(kernel, "dot_product").multiplications, 3u);
    EXPECT_EQ(count(kernel, "dot_product").additions, 2u);
    EXPECT_EQ(count(kernel, "make_barycentric").total(), 3u);
    EXPECT_EQ(count(kernel, "cubic_weights").multiplications, 3u * 2 + 6 * 3 + 3);
    EXPECT_EQ(count(kernel, "evaluate_cubic").multiplications, 3u * 10);
    EXPECT_EQ(count(kernel, "evaluate_cubic").additions, 3u * 9);
    EXPECT_EQ(count(kernel, "exact_rsqrt_of_normal").total(), 5u + 5 + 6);
}

TEST(FloatOperations, RootsAndDivisionsAreCountedApart) {
    // dot, root, scale
    const measure::FloatOperations normal = count("vertices_cubic_quadratic_triangle_shared", "blended_normal");
    EXPECT_EQ(normal.roots, 1u);
    EXPECT_EQ(normal.divisions, 0u);
    EXPECT_EQ(normal.total(), 5u + 16 + 3);
    EXPECT_EQ(normal.with_roots_as_one(), 5u + 1 + 3);
    const measure::FloatOperations edge = count("control_net_pn_quadratic_triangle", "edge_normal");
    EXPECT_EQ(edge.roots, 1u);
    EXPECT_EQ(edge.divisions, 1u);
}

TEST(FloatOperations, OfAKernelAreThoseOfAllItCalls) {
    // The linear scheme: barycentric weights; position, normal and texture coordinates; a unit normal.
    const measure::FloatOperations linear = count("vertices_linear_linear_triangle_shared");
    EXPECT_EQ(linear.total(), 3u + 8 * 5 + 24);
    // Patterns that a patch makes for itself take integers only.
    EXPECT_EQ(count("vertices_linear_linear_triangle").total(), linear.total());
    const measure::FloatOperations net = count("control_net_linear_linear_triangle");
    EXPECT_EQ(net.total(), 0u);
}

TEST(FloatOperations, DifferencesAreParts) {
    const auto whole = count("vertices_cubic_quadratic_triangle_shared");
    const auto part = count("vertices_cubic_quadratic_triangle_shared", "blended_normal");
    EXPECT_EQ((whole - part + part).total(), whole.total());
    EXPECT_EQ((whole - part).roots, 0u);
}

TEST(FloatOperations, WhatIsNoModuleIsRefused) {
    EXPECT_THROW(measure::count_float_operations({}), Error);
    EXPECT_THROW(measure::count_float_operations(std::vector<std::uint32_t>(9, 1)), Error);
    EXPECT_THROW(count("scale_probe", "no_such_function"), Error);
    const auto spirv = gpu::find_kernel("scale_probe").spirv;
    EXPECT_THROW(measure::count_float_operations(spirv.first(spirv.size() - 2)), Error);
}

}  // namespace
}  // namespace tessera
