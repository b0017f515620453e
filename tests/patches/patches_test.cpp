// Patches from scenes: exact scaling into kernel space and back, flushing, ranges, and what is refused.
#include "patches/patches.hpp"

#include "base/error.hpp"
#include "scene/shapes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace tessera::patches {
namespace {

scene::Mesh triangle(float size, const std::string& name = "triangle") {
    scene::Mesh mesh;
    mesh.name = name;
    mesh.positions = {{0.0f, 0.0f, 0.0f}, {size, 0.0f, 0.0f}, {0.0f, size * 0.5f, 0.0f}};
    mesh.normals.assign(3, {0.0f, 0.0f, 1.0f});
    mesh.uvs = {{0.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}};
    mesh.triangles = {0, 1, 2};
    return mesh;
}

scene::Scene scene_of(std::vector<scene::Mesh> meshes) {
    scene::Scene scene;
    scene.source = "test.glb";
    scene.meshes = std::move(meshes);
    scene.materials.resize(1);
    return scene;
}

float largest_coordinate(const PatchSet& set) {
    float largest = 0.0f;
    for (const Vertex& vertex : set.control_vertices) {
        for (const float x : vertex.position) {
            largest = std::max(largest, std::fabs(x));
        }
    }
    return largest;
}

TEST(Patches, StrayVerticesDoNotScaleTheModel) {
    scene::Mesh mesh = triangle(1.5f);
    const PatchSet expected = make_patches(scene_of({mesh}));
    mesh.positions.push_back({1e38f, -1e38f, 1e-38f});
    mesh.normals.push_back({0.0f, 0.0f, 1.0f});
    mesh.uvs.push_back({0.0f, 0.0f});
    const PatchSet set = make_patches(scene_of({mesh}));
    EXPECT_EQ(set.exponent, expected.exponent);
    EXPECT_EQ(std::memcmp(set.control_vertices.data(), expected.control_vertices.data(), 3 * sizeof(Vertex)), 0);
    EXPECT_EQ(set.control_vertices[3].position[0], 2.0f);
    EXPECT_EQ(set.control_vertices[3].position[1], -2.0f);
}

TEST(Patches, ScaleTheLargestCoordinateIntoOneToTwo) {
    for (const float size : {1.0f, 1.999f, 2.0f, 3.0f, 1e-30f, 1e30f, 0x1p-126f, std::numeric_limits<float>::max(),
                             std::numeric_limits<float>::denorm_min()}) {
        const PatchSet set = make_patches(scene_of({triangle(size), triangle(size * 0.25f)}));
        EXPECT_GE(largest_coordinate(set), 1.0f) << size;
        EXPECT_LT(largest_coordinate(set), 2.0f) << size;
        EXPECT_EQ(to_model_space(set.control_vertices[1].position[0], set.exponent), size);
    }
}

RC_GTEST_PROP(Patches, ScalingBackIsExact, ()) {
    const std::uint32_t exponent = *rc::gen::inRange(1u, 255u);
    const float size = std::bit_cast<float>(exponent << 23u | *rc::gen::inRange(0u, 1u << 23u));
    const PatchSet set = make_patches(scene_of({triangle(size)}));
    RC_ASSERT(to_model_space(set.control_vertices[1].position[0], set.exponent) == size);
}

TEST(Patches, FlushWhatWouldGiveDenormals) {
    scene::Mesh mesh = triangle(1024.0f);
    mesh.positions[0] = {0x1p-50f, -0x1.fffffep-51f, 0x1p-140f};
    mesh.normals[0] = {0x1p-61f, -0x1p-60f, 1.0f};
    mesh.uvs[0] = {-0x1p-70f, 0x1p-59f};
    const Vertex vertex = make_patches(scene_of({mesh})).control_vertices[0];
    EXPECT_EQ(vertex.position[0], 0x1p-60f);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(vertex.position[1]), 0u);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(vertex.position[2]), 0u);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(vertex.normal[0]), 0u);
    EXPECT_EQ(vertex.normal[1], -0x1p-60f);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(vertex.uv[0]), 0u);
    EXPECT_EQ(vertex.uv[1], 0x1p-59f);
}

TEST(Patches, AllZeroPositionsStayZero) {
    const PatchSet set = make_patches(scene_of({triangle(0.0f)}));
    EXPECT_EQ(set.exponent, 0);
    EXPECT_EQ(largest_coordinate(set), 0.0f);
}

TEST(Patches, RangesFollowTheMeshes) {
    scene::Scene torus = scene::make_shape("shape:torus");
    scene::Mesh second = triangle(1.0f, "second");
    second.material = 3;
    torus.meshes.push_back(second);
    const PatchSet set = make_patches(torus);
    ASSERT_EQ(set.ranges.size(), 2u);
    EXPECT_EQ(set.ranges[0].first_patch, 0u);
    EXPECT_EQ(set.ranges[0].patch_count, 192u);
    EXPECT_EQ(set.ranges[1].first_patch, 192u);
    EXPECT_EQ(set.ranges[1].patch_count, 1u);
    EXPECT_EQ(set.ranges[1].name, "second");
    EXPECT_EQ(set.ranges[1].material, 3u);
    EXPECT_EQ(set.patch_count(), 193u);
    // Indices of the second mesh count on from the vertices of the first.
    const auto base = static_cast<std::uint32_t>(torus.meshes[0].positions.size());
    EXPECT_EQ(set.corners[192], (PatchCorners{base, base + 1, base + 2, no_corner}));
    EXPECT_EQ(set.control_vertices.size(), base + 3u);
}

TEST(Patches, NothingToTessellateIsRefused) {
    try {
        make_patches(scene_of({}));
        FAIL() << "was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_STREQ(error.what(), "test.glb holds no triangles or quads, so there is nothing to tessellate.");
    }
}

TEST(Patches, ToModelSpaceOverflowsAndUnderflowsLikeAFloat) {
    EXPECT_EQ(to_model_space(1.5f, 127), 0x1.8p127f);
    EXPECT_TRUE(std::isinf(to_model_space(2.0f, 127)));
    EXPECT_EQ(to_model_space(1.0f, -149), std::numeric_limits<float>::denorm_min());
    EXPECT_EQ(to_model_space(0x1p-60f, -149), 0.0f);
}

}  // namespace
}  // namespace tessera::patches
