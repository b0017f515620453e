#include "measure/distance.hpp"

#include "base/error.hpp"
#include "surfaces.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <random>

namespace tessera {
namespace {

using glm::dvec3;

TEST(Distance, ToATriangle) {
    const dvec3 a(0, 0, 0), b(2, 0, 0), c(0, 2, 0);
    const auto to = [&](double x, double y, double z) { return measure::distance_to_triangle({x, y, z}, a, b, c); };
    EXPECT_DOUBLE_EQ(to(0.5, 0.5, 0), 0.0);
    EXPECT_DOUBLE_EQ(to(0.5, 0.5, -3), 3.0);  // over the inside
    EXPECT_DOUBLE_EQ(to(1, -2, 0), 2.0);      // beside each edge
    EXPECT_DOUBLE_EQ(to(-1, 1, 0), 1.0);
    EXPECT_DOUBLE_EQ(to(2, 2, 0), std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(to(-3, -4, 0), 5.0);  // beyond each corner
    EXPECT_DOUBLE_EQ(to(5, 0, 4), 5.0);
    EXPECT_DOUBLE_EQ(to(0, 2 + 3, 4), 5.0);
    EXPECT_DOUBLE_EQ(measure::distance_to_triangle({0, 1, 0}, a, b, {4, 0, 0}), 1.0);  // no area
    EXPECT_DOUBLE_EQ(measure::distance_to_triangle({0, 1, 0}, a, a, a), 1.0);
}

// Against brute force over a fine grid of points.
TEST(Distance, ToATriangleIsThatOfItsNearestPoint) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    const auto point = [&] { return dvec3(coordinate(random), coordinate(random), coordinate(random)); };
    for (int round = 0; round < 50; ++round) {
        const dvec3 a = point(), b = point(), c = point(), p = 2.0 * point();
        double least = 1e9;
        constexpr int steps = 400;
        for (int i = 0; i <= steps; ++i) {
            for (int j = 0; i + j <= steps; ++j) {
                const double u = double(i) / steps, v = double(j) / steps;
                least = std::min(least, glm::length(p - ((1 - u - v) * a + u * b + v * c)));
            }
        }
        const double distance = measure::distance_to_triangle(p, a, b, c);
        EXPECT_LE(distance, least + 1e-12);
        EXPECT_GE(distance, least - 0.01);
    }
}

TEST(Distance, OfAPlaneIsNothing) {
    const patches::PatchSet plane = test::folded_sheet(0.0, false);
    const auto fine = test::make_surface(plane, {}, 32);
    TessellationOptions options;
    options.partitioning = Partitioning::uniform;
    const auto coarse = test::make_surface(plane, options, 3);
    EXPECT_LT(measure::distance_of_vertices(fine, coarse).max, 1e-6);
    EXPECT_LT(measure::distance_between(fine, coarse, 3).max, 1e-6);
    EXPECT_NEAR(measure::diagonal(coarse), std::sqrt(5.0), 1e-6);
}

// The chord of an arc: a face of the flat icosahedron lies inside the sphere by 1 - its inradius, where the curved one
// almost touches the sphere.
TEST(Distance, OfTheIcosahedronFromItsSphere) {
    const patches::PatchSet icosahedron = test::load_patches("shape:icosahedron");
    TessellationOptions options;
    options.scheme = Scheme::linear;
    const auto flat = test::make_surface(icosahedron, options, 1);
    options.partitioning = Partitioning::integer;
    measure::PatchSurface sphere = test::make_surface(icosahedron, options, 16);  // with a point in the middle
    for (Vertex& v : sphere.vertices) {
        const float length = std::hypot(v.position[0], v.position[1], v.position[2]);
        for (float& x : v.position)
            x /= length;
    }
    const double inradius = std::sqrt((5 + 2 * std::sqrt(5.0)) / 15);
    const measure::DistanceStatistics distances = measure::distance_of_vertices(sphere, flat);
    EXPECT_EQ(distances.count, sphere.vertices.size());
    EXPECT_NEAR(distances.max, 1 - inradius, 1e-6);
    EXPECT_GT(distances.mean, 0.3 * distances.max);
    // Not the other way round: a flat triangle's points are nearer to its own corner of the sphere.
    EXPECT_NEAR(measure::distance_between(sphere, flat, 2).max, 1 - inradius, 2e-2);
}

// Twice the segments, a quarter of the distance.
TEST(Distance, ShrinksWithTheSquareOfTheFactor) {
    const patches::PatchSet torus = test::load_patches("shape:torus");
    TessellationOptions options;
    options.partitioning = Partitioning::uniform;
    const auto exact = test::make_surface(torus, options, 48);
    const double coarse = measure::distance_of_vertices(exact, test::make_surface(torus, options, 4)).mean;
    const double fine = measure::distance_of_vertices(exact, test::make_surface(torus, options, 8)).mean;
    EXPECT_NEAR(coarse / fine, 4.0, 0.4);
}

TEST(Distance, OfDifferentPatchesIsRefused) {
    const auto a = test::make_surface(test::load_patches("shape:icosahedron"), {}, 2);
    const auto b = test::make_surface(test::load_patches("shape:torus"), {}, 2);
    EXPECT_THROW(measure::distance_of_vertices(a, b), Error);
    EXPECT_THROW(measure::distance_between(a, b, 2), Error);
}

}  // namespace
}  // namespace tessera
