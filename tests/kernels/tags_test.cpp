// Scalar tags and alpha per vertex: without tags the scheme is PN; what two patches share has the same bits in both.
#include "kernels/corners_gen.hpp"
#include "kernels/paper.hpp"
#include "schemes/basis.h"
#include "schemes/phong.h"
#include "schemes/phong_quad.h"
#include "schemes/stpn.h"
#include "schemes/stpn_quad.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

namespace tessera::kernels {
namespace {

using glm::dvec3;

dvec3 widen(Vector v) {
    return {v.x, v.y, v.z};
}

bool equal_bits(Vector a, Vector b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

float uniform(std::mt19937& random, float least, float greatest) {
    return std::uniform_real_distribution<float>(least, greatest)(random);
}

VertexTags random_tags(std::mt19937& random) {
    VertexTags tags{};
    tags.sharpness = random() % 3 == 0 ? 0.0f : uniform(random, 0.0f, 1.0f);
    tags.bias = uniform(random, -1.0f, 1.0f);
    tags.tension = uniform(random, -1.0f, 1.0f);
    tags.alpha = uniform(random, 0.0f, 1.0f);
    if (random() % 2 == 0) tags.crease = test::random_unit(random);
    tags.normal = test::random_unit(random);
    return tags;
}

CornerTags corner_tags(Vector normal, float edge) {
    CornerTags tags{};
    tags.normal = normal;
    tags.edge = edge;
    return tags;
}

QuadCorners random_quad(std::uint32_t seed) {
    const Corners a = test::random_corners(2 * seed);
    const Corners b = test::random_corners(2 * seed + 1);
    return {a.p0, a.p1, a.p2, b.p0, a.n0, a.n1, a.n2, b.n0};
}

TEST(Tags, WithoutTagsTheNetIsThatOfPn) {
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        const Corners c = test::random_corners(seed);
        const VertexTags none{};
        const PnNet tagged =
            stpn_net(c, corner_tags(c.n0, 0.0f), corner_tags(c.n1, 0.0f), corner_tags(c.n2, 0.0f), none, none, none);
        const PnNet plain = pn_net(c);
        ASSERT_EQ(std::memcmp(&tagged, &plain, sizeof plain), 0) << seed;
        const QuadCorners q = random_quad(seed);
        const PnQuadNet tagged_quad =
            stpn_quad_net(q, corner_tags(q.n0, 0.0f), corner_tags(q.n1, 0.0f), corner_tags(q.n2, 0.0f),
                          corner_tags(q.n3, 0.0f), none, none, none, none);
        const PnQuadNet plain_quad = pn_quad_net(q);
        ASSERT_EQ(std::memcmp(&tagged_quad, &plain_quad, sizeof plain_quad), 0) << seed;
    }
}

// The formula of stpn.h in double precision.
dvec3 expected_point(dvec3 pa, dvec3 corner_normal, const VertexTags& a, dvec3 pb, double s) {
    const dvec3 d = pb - pa;
    const dvec3 n = s > 0.0 ? widen(a.normal) : corner_normal;
    const double sharp = a.sharpness;
    const dvec3 smooth = d - (1.0 - sharp) * (1.0 + a.bias) * glm::dot(d, n) * n;
    const dvec3 c = widen(a.crease);
    const dvec3 along = glm::dot(c, c) > 0.0 ? glm::dot(d, c) * c : d;
    return pa + (1.0 - a.tension) / 3.0 * ((1.0 - s) * smooth + s * (sharp * d + (1.0 - sharp) * along));
}

TEST(Tags, EdgePointsAreThoseOfTheFormula) {
    std::mt19937 random(3);
    for (std::uint32_t seed = 0; seed < 5000; ++seed) {
        const Corners c = test::random_corners(seed);
        const VertexTags tags = random_tags(random);
        const float s = std::array{0.0f, 1.0f, uniform(random, 0.0f, 1.0f)}[random() % 3];
        const Vector found = stpn_edge_point(c.p0, corner_tags(c.n0, 0.0f), tags, c.p1, s);
        EXPECT_LT(glm::distance(widen(found), expected_point(widen(c.p0), widen(c.n0), tags, widen(c.p1), s)), 4e-6);
    }
}

TEST(Tags, SharpEdgesAreStraight) {
    std::mt19937 random(4);
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        const Corners c = test::random_corners(seed);
        VertexTags tags{};
        tags.normal = test::random_unit(random);
        const Vector third = add(c.p0, scale(subtract(c.p1, c.p0), ONE_THIRD));
        EXPECT_TRUE(equal_bits(stpn_edge_point(c.p0, corner_tags(c.n0, 1.0f), tags, c.p1, 1.0f), third));
        tags.sharpness = 1.0f;  // a corner: every edge leaves straight
        EXPECT_LT(glm::distance(widen(stpn_edge_point(c.p0, corner_tags(c.n0, 0.0f), tags, c.p1, 0.0f)), widen(third)),
                  1e-6);
    }
}

// Faces on both sides of a crease have normals of their own, and the edge still has one curve.
TEST(Tags, EdgesHaveTheSameBitsFromEitherPatch) {
    std::mt19937 random(5);
    for (std::uint32_t seed = 0; seed < 5000; ++seed) {
        const Corners one = test::random_corners(2 * seed);
        const Corners two = test::random_corners(2 * seed + 1);
        const VertexTags a = random_tags(random);
        const VertexTags b = random_tags(random);
        const VertexTags other = random_tags(random);
        const float s = random() % 2 == 0 ? 0.0f : uniform(random, 1e-6f, 1.0f);
        const Vector na = s > 0.0f ? two.n0 : one.n0;
        const Vector nb = s > 0.0f ? two.n1 : one.n1;
        Corners left = one;                                     // edge 0 -> 1
        Corners right{one.p1, one.p0, two.p2, nb, na, two.n2};  // the same edge backwards
        const PnNet l =
            stpn_net(left, corner_tags(one.n0, s), corner_tags(one.n1, 0.3f), corner_tags(one.n2, 0.7f), a, b, other);
        const PnNet r =
            stpn_net(right, corner_tags(nb, s), corner_tags(na, 0.0f), corner_tags(two.n2, 0.1f), b, a, other);
        ASSERT_TRUE(equal_bits(l.c01, r.c10) && equal_bits(l.c10, r.c01)) << seed;
        const QuadCorners q{one.p1, one.p0, two.p2, two.p1, nb, na, two.n2, two.n1};
        const PnQuadNet quad = stpn_quad_net(q, corner_tags(nb, s), corner_tags(na, 0.0f), corner_tags(two.n2, 0.1f),
                                             corner_tags(two.n1, 0.9f), b, a, other, other);
        ASSERT_TRUE(equal_bits(l.c01, quad.c10) && equal_bits(l.c10, quad.c01)) << seed;
    }
}

TEST(Tags, PhongBlendsEachCornersProjectionByItsAlpha) {
    std::mt19937 random(6);
    for (std::uint32_t seed = 0; seed < 500; ++seed) {
        const Corners c = test::random_corners(seed);
        const float alpha[3] = {uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1)};
        const test::PaperPatch patch = test::paper_patch(c);
        const PhongNet net = phong_net(c, alpha[0], alpha[1], alpha[2]);
        for (uint u = 0; u <= 65536; u += 8192) {
            for (uint v = 0; v + u <= 65536; v += 8192) {
                const Barycentric b = make_barycentric(u, v);
                const dvec3 weights{b.u, b.v, b.w};
                const dvec3 p = test::paper_linear(patch.p, weights);
                dvec3 expected(0.0);
                for (int i = 0; i < 3; ++i) {
                    expected += weights[i] * (p - double{alpha[i]} * glm::dot(p - patch.p[i], patch.n[i]) * patch.n[i]);
                }
                const Vector found =
                    evaluate_quadratic(quadratic_weights(b, 2.0f), net.c0, net.c1, net.c2, net.c01, net.c12, net.c20);
                ASSERT_LT(glm::distance(widen(found), expected), 5e-6);
            }
        }
        const PhongNet turned = phong_net({c.p1, c.p0, c.p2, c.n1, c.n0, c.n2}, alpha[1], alpha[0], 0.5f);
        ASSERT_TRUE(equal_bits(net.c01, turned.c01));
    }
}

TEST(Tags, AlphaZeroAtOneCornerLeavesItsPlaneOut) {
    const Corners c = test::random_corners(8);
    const Vector mean = scale(add(c.p0, c.p1), 0.5f);
    EXPECT_LT(glm::distance(widen(phong_net(c, 0, 0, 1).c01), widen(mean)), 1e-6);
    EXPECT_GT(glm::distance(widen(phong_net(c, 0, 1, 0).c01), widen(mean)), 1e-3);
}

}  // namespace
}  // namespace tessera::kernels
