// Nets and bases against the papers, and what must hold for corners that no paper thinks of.
#include "kernels/corners_gen.hpp"
#include "kernels/paper.hpp"
#include "schemes/basis.h"
#include "schemes/linear.h"
#include "schemes/phong.h"
#include "schemes/pn.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace tessera::kernels {
namespace {

using glm::dvec3;

Vector pn_position(const Corners& corners, Barycentric b) {
    const PnNet n = pn_net(corners);
    return evaluate_cubic(cubic_weights(b), n.c0, n.c1, n.c2, n.c01, n.c10, n.c12, n.c21, n.c20, n.c02, n.centre);
}

Vector phong_position(const Corners& corners, float alpha, Barycentric b) {
    const PhongNet n = phong_net(corners, alpha, alpha, alpha);
    return evaluate_quadratic(quadratic_weights(b, 2.0f), n.c0, n.c1, n.c2, n.c01, n.c12, n.c20);
}

Vector linear_position(const Corners& corners, Barycentric b) {
    const LinearNet n = linear_net(corners);
    return evaluate_linear(b, n.c0, n.c1, n.c2);
}

Vector quadratic_normal(const Corners& c, Barycentric b) {
    return evaluate_quadratic(quadratic_weights(b, 1.0f), c.n0, c.n1, c.n2, edge_normal(c.p0, c.n0, c.p1, c.n1),
                              edge_normal(c.p1, c.n1, c.p2, c.n2), edge_normal(c.p2, c.n2, c.p0, c.n0));
}

double distance(Vector a, dvec3 b) {
    return glm::length(dvec3(a.x, a.y, a.z) - b);
}
double distance(Vector a, Vector b) {
    return distance(a, dvec3(b.x, b.y, b.z));
}
bool finite(Vector v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
dvec3 widen(Barycentric b) {
    return {b.u, b.v, b.w};
}

Barycentric any_point() {
    const uint u = *rc::gen::inRange(0u, 65537u);
    return make_barycentric(u, *rc::gen::inRange(0u, 65537u - u));
}

Corners any_corners() {
    return test::random_corners(*rc::gen::arbitrary<std::uint32_t>());
}

RC_GTEST_PROP(Schemes, PnIsThatOfVlachosEtAl, ()) {
    const Corners corners = any_corners();
    const Barycentric b = any_point();
    RC_ASSERT(distance(pn_position(corners, b), test::paper_pn_position(test::paper_patch(corners), widen(b))) < 1e-5);
}

RC_GTEST_PROP(Schemes, PhongIsThatOfBoubekeurAndAlexa, ()) {
    const Corners corners = any_corners();
    const Barycentric b = any_point();
    const float alpha = static_cast<float>(*rc::gen::inRange(0, 101)) / 100.0f;
    const dvec3 expected = test::paper_phong_position(test::paper_patch(corners), alpha, widen(b));
    RC_ASSERT(distance(phong_position(corners, alpha, b), expected) < 1e-5);
}

RC_GTEST_PROP(Schemes, LinearIsTheTriangle, ()) {
    const Corners corners = any_corners();
    const Barycentric b = any_point();
    RC_ASSERT(distance(linear_position(corners, b), test::paper_linear(test::paper_patch(corners).p, widen(b))) < 1e-6);
}

RC_GTEST_PROP(Schemes, QuadraticNormalsAreThoseOfVlachosEtAl, ()) {
    const Corners corners = any_corners();
    const Barycentric b = any_point();
    const dvec3 expected = test::paper_quadratic_normal(test::paper_patch(corners), widen(b));
    RC_ASSERT(distance(quadratic_normal(corners, b), expected) < 1e-5);
}

TEST(Schemes, CornersAreInterpolatedExactly) {
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        const Corners c = test::random_corners(seed);
        const Barycentric at[3] = {make_barycentric(65536, 0), make_barycentric(0, 65536), make_barycentric(0, 0)};
        const Vector p[3] = {c.p0, c.p1, c.p2};
        const Vector n[3] = {c.n0, c.n1, c.n2};
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(distance(pn_position(c, at[i]), p[i]), 0.0);
            EXPECT_EQ(distance(phong_position(c, 0.75f, at[i]), p[i]), 0.0);
            EXPECT_EQ(distance(linear_position(c, at[i]), p[i]), 0.0);
            EXPECT_EQ(distance(quadratic_normal(c, at[i]), n[i]), 0.0);
        }
    }
}

TEST(Schemes, AFlatTriangleStaysFlat) {
    Corners c = test::random_corners(5);
    const float height = 0.625f;
    c.p0.z = c.p1.z = c.p2.z = height;
    c.n0 = c.n1 = c.n2 = make_vector(0.0f, 0.0f, 1.0f);
    for (uint u = 0; u <= 65536; u += 4096) {
        for (uint v = 0; v + u <= 65536; v += 4096) {
            const Barycentric b = make_barycentric(u, v);
            EXPECT_NEAR(pn_position(c, b).z, height, 2e-7f);
            EXPECT_NEAR(phong_position(c, 1.0f, b).z, height, 2e-7f);
            const dvec3 flat = test::paper_linear(test::paper_patch(c).p, widen(b));
            EXPECT_LT(distance(pn_position(c, b), flat), 2e-6);
            EXPECT_LT(distance(phong_position(c, 1.0f, b), flat), 2e-6);
            EXPECT_LT(distance(normalise(quadratic_normal(c, b), c.n0), c.n0), 1e-6);
        }
    }
}

TEST(Schemes, AlphaZeroIsFlat) {
    const Corners c = test::random_corners(9);
    for (uint u = 0; u <= 65536; u += 8192) {
        const Barycentric b = make_barycentric(u, 65536 - u);
        EXPECT_LT(distance(phong_position(c, 0.0f, b), linear_position(c, b)), 1e-6);
    }
}

/// Corners that give a division by zero to whoever does not look.
class Degenerate : public testing::TestWithParam<int> {
protected:
    Corners corners() const {
        const Vector zero = make_vector(0.0f, 0.0f, 0.0f);
        Corners c = test::random_corners(21);
        switch (GetParam()) {
            case 0:
                c.p1 = c.p0;
                break;
            case 1:
                c.p1 = c.p2 = c.p0;
                break;
            case 2:
                c.n0 = c.n1 = c.n2 = zero;
                break;
            case 3:
                c.n1 = scale(c.n0, -1.0f);
                break;
            case 4:
                c.n1 = zero;
                break;
            case 5:
                c.p0 = c.p1 = c.p2 = zero;
                c.n0 = zero;
                break;
            case 6:
                c.p1 = add(c.p0, make_vector(0x1p-23f, 0.0f, 0.0f));
                break;
            default:
                c.p2 = scale(add(c.p0, c.p1), 0.5f);
                break;  // no area
        }
        return c;
    }
};

TEST_P(Degenerate, GivesFiniteResults) {
    const Corners c = corners();
    const Vector up = make_vector(0.0f, 0.0f, 1.0f);
    for (uint u = 0; u <= 65536; u += 4096) {
        for (uint v = 0; v + u <= 65536; v += 4096) {
            const Barycentric b = make_barycentric(u, v);
            EXPECT_TRUE(finite(pn_position(c, b)));
            EXPECT_TRUE(finite(phong_position(c, 1.0f, b)));
            EXPECT_TRUE(finite(linear_position(c, b)));
            const Vector n = normalise(quadratic_normal(c, b), up);
            EXPECT_TRUE(finite(n));
            EXPECT_NEAR(distance(n, dvec3(0.0)), 1.0, 1e-6);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Corners, Degenerate, testing::Range(0, 8));

TEST(Degenerate, OppositeNormalsGiveNoEdgeNormal) {
    const Vector n = make_vector(0.0f, 1.0f, 0.0f);
    const Vector h = edge_normal(make_vector(0, 0, 0), n, make_vector(1, 0, 0), scale(n, -1.0f));
    EXPECT_EQ(distance(h, dvec3(0.0)), 0.0);
}

}  // namespace
}  // namespace tessera::kernels
