// Which guides are neighbours, and guides as the kernels get them.
#include "patches/hair.hpp"

#include "base/error.hpp"
#include "layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace tessera::patches {
namespace {

std::vector<HairPatch> neighbours(const std::vector<glm::vec3>& roots, const std::vector<glm::vec3>& normals = {}) {
    return neighbouring_guides(roots,
                               normals.empty() ? std::vector<glm::vec3>(roots.size(), glm::vec3(0.0f)) : normals);
}

std::size_t guides_of(const HairPatch& patch) {
    return patch[1] == no_guide ? 1 : (patch[2] == no_guide ? 2 : 3);
}

TEST(GuideNeighbours, CoverAGridOnce) {
    constexpr int size = 12;
    std::vector<glm::vec3> roots;
    for (int i = 0; i < size * size; ++i)
        roots.emplace_back(i % size, i / size, 3.0f);
    const std::vector<HairPatch> patches = neighbours(roots);
    double area = 0.0;
    for (const HairPatch& patch : patches) {
        ASSERT_EQ(guides_of(patch), 3u);
        ASSERT_TRUE(patch[0] < patch[1] && patch[1] < patch[2]);
        area += 0.5 * glm::length(glm::cross(roots[patch[1]] - roots[patch[0]], roots[patch[2]] - roots[patch[0]]));
    }
    // Every square is cut in two, by one diagonal: both would make four triangles.
    EXPECT_EQ(patches.size(), 2u * (size - 1) * (size - 1));
    EXPECT_NEAR(area, (size - 1) * (size - 1), 1e-3);
    EXPECT_EQ(neighbours(roots), patches);
}

TEST(GuideNeighbours, ARowMakesPairs) {
    std::vector<glm::vec3> roots;
    for (int i = 0; i < 30; ++i)
        roots.emplace_back(0.0f, i, 0.0f);
    const std::vector<HairPatch> patches = neighbours(roots);
    ASSERT_EQ(patches.size(), 29u);
    for (std::uint32_t i = 0; i < 29; ++i)
        EXPECT_EQ(patches[i], (HairPatch{i, i + 1, no_guide}));
}

TEST(GuideNeighbours, FewOrCoincidentGuidesAreFine) {
    EXPECT_TRUE(neighbours({}).empty());
    EXPECT_EQ(neighbours({{1, 2, 3}}), (std::vector<HairPatch>{{0, no_guide, no_guide}}));
    EXPECT_EQ(neighbours({{1, 2, 3}, {0, 0, 0}}), (std::vector<HairPatch>{{0, 1, no_guide}}));
    EXPECT_EQ(neighbours({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (std::vector<HairPatch>{{0, 1, 2}}));
    std::set<std::uint32_t> met;
    for (const HairPatch& patch : neighbours(std::vector<glm::vec3>(100, {1, 1, 1})))
        met.insert(patch.begin(), patch.begin() + static_cast<std::ptrdiff_t>(guides_of(patch)));
    EXPECT_EQ(met.size(), 100u) << "every guide has hair";
}

TEST(GuideNeighbours, NormalsKeepTheSidesOfSomethingThinApart) {
    // Two sheets of four roots, closer to each other than the roots are.
    std::vector<glm::vec3> roots, normals;
    for (const float z : {0.0f, 0.1f}) {
        for (const glm::vec2 xy : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(1, 1)}) {
            roots.emplace_back(xy, z);
            normals.emplace_back(0.0f, 0.0f, z > 0.0f ? 1.0f : -1.0f);
        }
    }
    for (const HairPatch& patch : neighbours(roots, normals)) {
        const bool front = patch[0] >= 4;
        for (const std::uint32_t guide : patch)
            EXPECT_TRUE(guide == no_guide || (guide >= 4) == front);
    }
}

scene::Scene scene_of_guides() {
    scene::Scene scene;
    scene.source = "test.glb";
    scene.materials.resize(2);
    scene::Guides first{"first", {{0, 0, 0}, {0, 8, 0}, {0, 8, 1e-12f}, {1, 0, 0}, {1, 4, 0}}, {}, {}, {3, 5}, 1};
    first.normals.assign(5, glm::vec3(0, 0, 1));
    first.widths = {1.0f, 0.5f, scene::no_width, 1e30f, 0.0f};
    scene::Guides second{"second", {{5, 0, 0}, {5, 1, 0}}, {}, {}, {2}, 0};
    second.normals.assign(2, glm::vec3(0));
    second.widths.assign(2, scene::no_width);
    scene.guides = {first, second};
    return scene;
}

TEST(Hair, IsScaledFlushedAndCutIntoSegments) {
    const HairSet set = make_hair(scene_of_guides());
    EXPECT_EQ(set.exponent, 3);
    ASSERT_EQ(set.points.size(), 7u);
    EXPECT_EQ(set.points[1].position[1], 1.0f);
    EXPECT_EQ(set.points[2].position[2], 0.0f) << "under 2^-30";
    EXPECT_EQ(set.points[0].width, 0.125f);
    EXPECT_EQ(set.points[3].width, largest_hair_width);
    EXPECT_NEAR(set.points[2].width, default_hair_width * 6.0 / 8.0, 1e-6) << "of the mean length, (8 + 4) / 2";
    EXPECT_EQ(set.segments, (std::vector<std::uint32_t>{0u | SEGMENT_IS_FIRST, 1u | SEGMENT_IS_LAST,
                                                        3u | SEGMENT_IS_FIRST | SEGMENT_IS_LAST,
                                                        5u | SEGMENT_IS_FIRST | SEGMENT_IS_LAST}));
    ASSERT_EQ(set.guides.size(), 3u);
    EXPECT_EQ(set.guides[2].first_segment, 3u);
    EXPECT_EQ(set.patches, (std::vector<HairPatch>{{0, 1, no_guide}, {2, no_guide, no_guide}}));
    ASSERT_EQ(set.ranges.size(), 2u);
    EXPECT_EQ(set.ranges[1].first_patch, 1u);
    EXPECT_EQ(set.ranges[0].material, 1u);
}

TEST(Hair, AWidthReplacesThoseOfTheFile) {
    for (const GuidePoint& point : make_hair(scene_of_guides(), 2.0f).points)
        EXPECT_EQ(point.width, 0.25f);
    for (const float width : {-1.0f, std::nanf(""), INFINITY})
        EXPECT_THROW(make_hair(scene_of_guides(), width), Error);
    EXPECT_TRUE(make_hair({}).empty());
}

}  // namespace
}  // namespace tessera::patches
