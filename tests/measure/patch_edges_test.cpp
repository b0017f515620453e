#include "measure/patch_edges.hpp"

#include "surfaces.hpp"

#include <gtest/gtest.h>

namespace tessera {
namespace {

TEST(PatchEdges, OfAClosedShapeAreAllSharedByTwo) {
    const measure::PatchEdges torus = measure::find_edges(test::load_patches("shape:torus"));
    EXPECT_EQ(torus.smooth.size(), 192u * 3 / 2);  // seams of the texture included
    EXPECT_EQ(torus.split + torus.boundary + torus.crowded + torus.without_length, 0u);
    for (const measure::SharedEdge& edge : torus.smooth)
        EXPECT_TRUE(edge.reversed);
}

TEST(PatchEdges, AreToldApart) {
    const measure::PatchEdges whole = measure::find_edges(test::folded_sheet(1.0, false));
    EXPECT_EQ(whole.smooth.size(), 3u);  // two diagonals and the fold
    EXPECT_EQ(whole.split, 0u);
    EXPECT_EQ(whole.boundary, 6u);
    const measure::PatchEdges split = measure::find_edges(test::folded_sheet(1.0, true));
    EXPECT_EQ(split.smooth.size(), 2u);
    EXPECT_EQ(split.split, 1u);

    patches::PatchSet crowded = test::folded_sheet(1.0, false);
    crowded.corners.push_back({1, 2, 3, patches::no_corner});
    crowded.corners.push_back({1, 6, 3, patches::no_corner});  // 1 and 6 are in one place
    const measure::PatchEdges more = measure::find_edges(crowded);
    EXPECT_EQ(more.crowded, 2u);  // the fold, and from there to 3
    EXPECT_EQ(more.without_length, 1u);
}

TEST(PatchEdges, PointsGoFromCornerToCorner) {
    const auto surface = test::make_surface(test::load_patches("shape:icosahedron"), {}, 5);
    for (std::uint32_t e = 0; e < 3; ++e) {
        const auto points = measure::points_on_edge(surface.triangle, false, e);
        ASSERT_EQ(points.size(), 6u);
        const auto corner = [](std::uint32_t c) { return std::pair(c == 0 ? 65536u : 0u, c == 1 ? 65536u : 0u); };
        const DomainPoint first = surface.triangle.points[points.front()];
        const DomainPoint last = surface.triangle.points[points.back()];
        EXPECT_EQ(std::pair(first.u, first.v), corner(e));
        EXPECT_EQ(std::pair(last.u, last.v), corner((e + 1) % 3));
    }
    const std::pair<std::uint32_t, std::uint32_t> corners[4] = {{0, 0}, {65536, 0}, {65536, 65536}, {0, 65536}};
    for (std::uint32_t e = 0; e < 4; ++e) {
        const auto points = measure::points_on_edge(surface.quad, true, e);
        ASSERT_EQ(points.size(), 6u);
        const DomainPoint first = surface.quad.points[points.front()];
        const DomainPoint last = surface.quad.points[points.back()];
        EXPECT_EQ(std::pair(first.u, first.v), corners[e]);
        EXPECT_EQ(std::pair(last.u, last.v), corners[(e + 1) % 4]);
    }
}

// Flat patches that meet in a fold: the surface turns by the fold there and by nothing in the diagonals; interpolated
// normals do not turn at all.
TEST(Discontinuity, OfAFoldIsItsAngle) {
    for (const double turn : {0.0, 20.0, 75.0}) {
        const patches::PatchSet fold = test::folded_sheet(turn * test::degree, false);
        const measure::PatchEdges edges = measure::find_edges(fold);
        TessellationOptions options;
        options.scheme = Scheme::linear;
        options.normals = Normals::surface;
        const auto angles = measure::discontinuity(test::make_surface(fold, options, 5), edges);
        EXPECT_EQ(angles.count, 3u * 6);
        EXPECT_NEAR(angles.max, turn * test::degree, 1e-6);
        EXPECT_NEAR(angles.mean, turn * test::degree / 3, 1e-6);
        for (const Normals normals : {Normals::linear, Normals::quadratic}) {
            options.normals = normals;
            EXPECT_EQ(measure::discontinuity(test::make_surface(fold, options, 5), edges).max, 0.0);
        }
    }
}

TEST(Discontinuity, SplitEdgesDoNotCount) {
    const patches::PatchSet fold = test::folded_sheet(1.0, true);
    TessellationOptions options;
    options.normals = Normals::linear;
    const auto angles = measure::discontinuity(test::make_surface(fold, options, 5), measure::find_edges(fold));
    EXPECT_EQ(angles.count, 2u * 6);
    EXPECT_EQ(angles.max, 0.0);
}

TEST(Discontinuity, QuadsAndTrianglesMeet) {
    patches::PatchSet sheet = test::folded_sheet(30 * test::degree, false);
    sheet.corners = {{0, 1, 2, 3}, {6, 4, 5, patches::no_corner}, {6, 5, 7, patches::no_corner}};
    sheet.has_quads = true;
    for (patches::PatchRange& range : sheet.ranges)
        range.patch_count = 3;
    TessellationOptions options;
    options.scheme = Scheme::linear;
    options.normals = Normals::surface;
    const auto angles = measure::discontinuity(test::make_surface(sheet, options, 3), measure::find_edges(sheet));
    EXPECT_EQ(angles.count, 2u * 4);
    EXPECT_NEAR(angles.max, 30 * test::degree, 1e-6);
}

TEST(Discontinuity, SharedNormalsOfSchemesAreContinuousBitByBit) {
    const patches::PatchSet torus = test::load_patches("shape:torus");
    const measure::PatchEdges edges = measure::find_edges(torus);
    for (const Scheme scheme : {Scheme::phong, Scheme::pn}) {
        TessellationOptions options;
        options.scheme = scheme;
        for (const Normals normals : {Normals::linear, Normals::quadratic}) {
            options.normals = normals;
            EXPECT_EQ(measure::discontinuity(test::make_surface(torus, options, 7), edges).max, 0.0);
        }
        options.normals = Normals::surface;
        EXPECT_GT(measure::discontinuity(test::make_surface(torus, options, 7), edges).max, 1 * test::degree);
    }
}

}  // namespace
}  // namespace tessera
