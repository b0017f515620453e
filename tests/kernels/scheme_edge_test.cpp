// A point on an edge has the same bits from either patch, whichever sides of the two patches the edge is, and does not
// depend on the opposite corner.
#include "kernels/corners_gen.hpp"
#include "schemes/basis.h"
#include "schemes/phong.h"
#include "schemes/pn.h"

#include <gtest/gtest.h>

#include <array>

namespace tessera::kernels {
namespace {

struct Sample {
    Vector pn, phong, linear, normal;
};

Sample evaluate(const Corners& c, Barycentric b) {
    const PnNet pn = pn_net(c);
    const PhongNet phong = phong_net(c, 0.75f, 0.75f, 0.75f);
    const auto flush = [](Vector v) { return flush_vector(v); };
    return {
        flush(evaluate_cubic(cubic_weights(b), pn.c0, pn.c1, pn.c2, pn.c01, pn.c10, pn.c12, pn.c21, pn.c20, pn.c02,
                             pn.centre)),
        flush(evaluate_quadratic(quadratic_weights(b, 2.0f), phong.c0, phong.c1, phong.c2, phong.c01, phong.c12,
                                 phong.c20)),
        flush(evaluate_linear(b, c.p0, c.p1, c.p2)),
        normalise(evaluate_quadratic(quadratic_weights(b, 1.0f), c.n0, c.n1, c.n2, edge_normal(c.p0, c.n0, c.p1, c.n1),
                                     edge_normal(c.p1, c.n1, c.p2, c.n2), edge_normal(c.p2, c.n2, c.p0, c.n0)),
                  make_vector(0.0f, 0.0f, 1.0f))};
}

bool same_bits(Vector a, Vector b) {
    return float_bits(a.x) == float_bits(b.x) && float_bits(a.y) == float_bits(b.y) &&
           float_bits(a.z) == float_bits(b.z);
}

struct Corner {
    Vector p, n;
};

/// A patch whose edge from `a` to `b` begins at corner `first`.
Corners place(Corner a, Corner b, Corner opposite, unsigned first) {
    std::array<Corner, 3> at;
    at[first] = a;
    at[(first + 1) % 3] = b;
    at[(first + 2) % 3] = opposite;
    return {at[0].p, at[1].p, at[2].p, at[0].n, at[1].n, at[2].n};
}

/// The point with weight `t` (16.16) at corner `first` and the rest at the next one.
Barycentric on_edge(uint t, unsigned first) {
    std::array<uint, 3> uvw{};
    uvw[first] = t;
    uvw[(first + 1) % 3] = 65536u - t;
    return make_barycentric(uvw[0], uvw[1]);
}

TEST(SchemeEdges, HaveTheSameBitsFromEitherPatch) {
    std::mt19937 random(17);
    int different = 0;
    for (std::uint32_t seed = 0; seed < 20000; ++seed) {
        const Corners one = test::random_corners(2 * seed);
        const Corners two = test::random_corners(2 * seed + 1);
        const Corner a{one.p0, one.n0};
        const Corner b{one.p1, one.n1};
        const unsigned i = random() % 3;
        const unsigned j = random() % 3;
        const uint t = random() % 65537u;
        const Sample left = evaluate(place(a, b, {one.p2, one.n2}, i), on_edge(t, i));
        const Sample right = evaluate(place(b, a, {two.p2, two.n2}, j), on_edge(65536u - t, j));
        different += same_bits(left.pn, right.pn) ? 0 : 1;
        different += same_bits(left.phong, right.phong) ? 0 : 1;
        different += same_bits(left.linear, right.linear) ? 0 : 1;
        different += same_bits(left.normal, right.normal) ? 0 : 1;
    }
    EXPECT_EQ(different, 0);
}

}  // namespace
}  // namespace tessera::kernels
