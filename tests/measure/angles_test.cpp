#include "measure/angles.hpp"

#include "backends/registry.hpp"
#include "base/error.hpp"
#include "surfaces.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace tessera {
namespace {

TEST(Angles, BetweenKnownVectors) {
    const float x[3] = {1, 0, 0};
    const float y[3] = {0, 3, 0};
    const float diagonal[3] = {1, 1, 0};
    const float back[3] = {-2, 0, 0};
    EXPECT_DOUBLE_EQ(measure::angle_between(x, y), 90 * test::degree);
    EXPECT_DOUBLE_EQ(measure::angle_between(x, diagonal), 45 * test::degree);
    EXPECT_DOUBLE_EQ(measure::angle_between(x, back), 180 * test::degree);
    EXPECT_EQ(measure::angle_between(diagonal, diagonal), 0.0);
    const float little[3] = {1, 1e-6f, 0};  // the cosine of this angle is 1 in single precision
    EXPECT_NEAR(measure::angle_between(x, little), 1e-6, 1e-12);
}

TEST(Angles, Statistics) {
    std::vector<double> angles;
    for (int i = 100; i >= 1; --i)
        angles.push_back(i);
    const measure::AngleStatistics statistics = measure::summarise(angles);
    EXPECT_EQ(statistics.count, 100u);
    EXPECT_EQ(statistics.mean, 50.5);
    EXPECT_EQ(statistics.most_95, 95.0);
    EXPECT_EQ(statistics.max, 100.0);
    EXPECT_EQ(measure::summarise({3.0}).most_95, 3.0);
    EXPECT_EQ(measure::summarise({}).count, 0u);
}

TEST(Angles, OfAPlaneAreZeroForEveryKindOfNormals) {
    const patches::PatchSet plane = test::folded_sheet(0.0, false);
    TessellationOptions options;
    const auto quadratic = test::make_surface(plane, options, 6);
    options.normals = Normals::surface;
    const auto surface = test::make_surface(plane, options, 6);
    const measure::AngleStatistics angles = measure::normal_angles(surface, quadratic);
    EXPECT_EQ(angles.count, surface.vertices.size());
    EXPECT_LT(angles.max, 1e-6);
}

// A flat patch whose corner normals lean 30 degrees: the surface of the scheme linear is the plane whatever they are.
TEST(Angles, OfLeaningNormalsAreTheirLean) {
    patches::PatchSet plane = test::folded_sheet(0.0, false);
    for (Vertex& v : plane.control_vertices) {
        v.normal[0] = 0.5f;
        v.normal[2] = static_cast<float>(std::sqrt(0.75));
    }
    TessellationOptions options;
    options.scheme = Scheme::linear;
    options.normals = Normals::linear;
    const auto linear = test::make_surface(plane, options, 5);
    options.normals = Normals::surface;
    const measure::AngleStatistics angles = measure::normal_angles(test::make_surface(plane, options, 5), linear);
    EXPECT_NEAR(angles.mean, 30 * test::degree, 1e-6);
    EXPECT_NEAR(angles.max, 30 * test::degree, 1e-6);
}

// On a fine sphere all normals are nearly those of the sphere, on a coarse one less so.
TEST(Angles, OfASphereShrinkAsItGetsFiner) {
    double last = 1.0;
    for (const char* name : {"shape:sphere:2", "shape:sphere:4", "shape:sphere:8"}) {
        const patches::PatchSet sphere = test::load_patches(name);
        TessellationOptions options;
        const auto quadratic = test::make_surface(sphere, options, 4);
        options.normals = Normals::surface;
        const double max = measure::normal_angles(test::make_surface(sphere, options, 4), quadratic).max;
        EXPECT_GT(max, 0.0);
        EXPECT_LT(max, last / 2) << name;
        last = max;
    }
}

TEST(Angles, OfDifferentSurfacesAreRefused) {
    TessellationOptions options;
    const patches::PatchSet sphere = test::load_patches("shape:icosahedron");
    const auto pn = test::make_surface(sphere, options, 4);
    EXPECT_THROW(measure::normal_angles(pn, test::make_surface(sphere, options, 6)), Error);
    options.scheme = Scheme::phong;
    EXPECT_THROW(measure::normal_angles(pn, test::make_surface(sphere, options, 4)), Error);
}

TEST(Angles, OnlyOneSetOfFactors) {
    TessellationOptions options;
    const patches::PatchSet sphere = test::load_patches("shape:icosahedron");
    options.factors = std::vector<PatchFactors>(20, PatchFactors{2, 2, 2, 2, 2, 2});
    const gpu::Device device = backends::open_device("reference");
    EXPECT_THROW(measure::make_patch_surface(device, sphere, options), Error);
    options.factors = PatchFactors{0, 2, 2, 2, 2, 2};
    EXPECT_NO_THROW(measure::make_patch_surface(device, sphere, options));
}

}  // namespace
}  // namespace tessera
