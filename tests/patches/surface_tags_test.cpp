// Creases, corners and scalar tags as patches carry them.
#include "patches/surface_tags.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace tessera::patches {
namespace {

/// A cube of quads with shared vertices and normals along its diagonals.
scene::Scene cube() {
    scene::Mesh mesh;
    mesh.positions = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                      {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
    for (const glm::vec3& p : mesh.positions)
        mesh.normals.push_back(glm::normalize(p));
    mesh.uvs.assign(8, glm::vec2(0.0f));
    mesh.quads = {3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
    scene::Scene scene;
    scene.materials.resize(1);
    scene.meshes.push_back(mesh);
    return scene;
}

glm::vec3 normal(const CornerTags& tags) {
    return {tags.normal[0], tags.normal[1], tags.normal[2]};
}

void crease_ring(scene::Scene& scene, float sharpness) {
    for (std::uint32_t i = 0; i < 4; ++i)
        scene.meshes[0].tags.creases.push_back({4 + i, 4 + (i + 1) % 4, sharpness});
}

TEST(SurfaceTags, SharesOfSharpness) {
    EXPECT_EQ(crease_share(0.0f), 0.0f);
    EXPECT_EQ(crease_share(-3.0f), 0.0f);
    EXPECT_EQ(crease_share(std::nanf("")), 0.0f);
    EXPECT_EQ(crease_share(1.0f), 0.5f);
    EXPECT_EQ(crease_share(1.5f), 0.625f);
    EXPECT_EQ(crease_share(2.0f), 0.75f);
    EXPECT_EQ(crease_share(10.0f), 1.0f);
    EXPECT_EQ(crease_share(1e30f), 1.0f);
    for (float s = 0.0f; s < 12.0f; s += 0.01f)
        EXPECT_LE(crease_share(s), crease_share(s + 0.01f)) << s;
}

TEST(SurfaceTags, ModelsWithoutTagsHaveNone) {
    const PatchSet set = make_patches(cube());
    EXPECT_TRUE(set.vertex_tags.empty());
    EXPECT_TRUE(set.corner_tags.empty());
}

TEST(SurfaceTags, AlphasAndScalarsGoWithTheirMesh) {
    scene::Scene scene = cube();
    scene.meshes.push_back(scene.meshes[0]);
    scene.meshes.push_back(scene.meshes[0]);
    scene.meshes[1].alphas.assign(8, 0.25f);
    scene.meshes[1].alphas[3] = 1e-20f;
    scene.meshes[2].stpn.assign(8, {0.5f, -1.0f, 0.125f});
    const PatchSet set = make_patches(scene);
    ASSERT_EQ(set.vertex_tags.size(), 24u);
    EXPECT_LT(set.vertex_tags[0].alpha, 0.0f) << "the option's";
    EXPECT_EQ(set.vertex_tags[8].alpha, 0.25f);
    EXPECT_EQ(set.vertex_tags[11].alpha, 0.0f) << "too small to matter";
    EXPECT_EQ(set.vertex_tags[16].sharpness, 0.5f);
    EXPECT_EQ(set.vertex_tags[16].bias, -1.0f);
    EXPECT_EQ(set.vertex_tags[16].tension, 0.125f);
    EXPECT_TRUE(set.corner_tags.empty());
}

TEST(SurfaceTags, SharpCreasesSplitNormals) {
    scene::Scene scene = cube();
    crease_ring(scene, 10.0f);
    const PatchSet set = make_patches(scene);
    ASSERT_EQ(set.corner_tags.size(), 6u);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(normal(set.corner_tags[1][k]), glm::vec3(0, 0, 1)) << "the face inside the ring";
        EXPECT_EQ(set.corner_tags[1][k].edge, 1.0f);
    }
    // A side, (0 1 5 4): below smooth as given, above without the share of the top.
    EXPECT_EQ(normal(set.corner_tags[2][0]), scene.meshes[0].normals[0]);
    EXPECT_NEAR(normal(set.corner_tags[2][2]).z, 0.0f, 1e-6f);
    EXPECT_NEAR(normal(set.corner_tags[2][2]).x, std::sqrt(0.5f), 1e-6f);
    EXPECT_EQ(set.corner_tags[2][2].edge, 1.0f) << "5 to 4";
    EXPECT_EQ(set.corner_tags[2][0].edge, 0.0f);
    // The neighbour across the smooth edge has the same bits.
    EXPECT_EQ(std::memcmp(set.corner_tags[2][2].normal, set.corner_tags[3][3].normal, 12), 0);
    // The crease runs through each vertex of the ring, along the diagonal.
    const VertexTags& tags = set.vertex_tags[4];
    EXPECT_NEAR(std::fabs(tags.crease[0]), std::sqrt(0.5f), 1e-6f);
    EXPECT_EQ(tags.crease[2], 0.0f);
    EXPECT_NEAR(tags.normal[2], std::sqrt(1.0f / 3.0f), 1e-6f);
    EXPECT_EQ(set.vertex_tags[0].crease[0], 0.0f);
}

TEST(SurfaceTags, SoftCreasesSplitNormalsInPart) {
    float last = 0.0f;
    for (const float sharpness : {0.0f, 0.5f, 1.0f, 3.0f, 10.0f}) {
        scene::Scene scene = cube();
        crease_ring(scene, sharpness);
        const PatchSet set = make_patches(scene);
        const float z = sharpness == 0.0f ? scene.meshes[0].normals[4].z : normal(set.corner_tags[1][0]).z;
        EXPECT_GT(z, last) << sharpness;
        last = z;
    }
    EXPECT_EQ(last, 1.0f);
}

TEST(SurfaceTags, CornersAreSharpVerticesAndEndCreases) {
    scene::Scene scene = cube();
    crease_ring(scene, 10.0f);
    scene.meshes[0].tags.corners.push_back({4, 10.0f});
    const PatchSet set = make_patches(scene);
    EXPECT_EQ(set.vertex_tags[4].sharpness, 1.0f);
    EXPECT_EQ(set.vertex_tags[4].crease[0], 0.0f);
    EXPECT_NE(set.vertex_tags[5].crease[0], 0.0f);
}

TEST(SurfaceTags, HoldForEveryVertexAtThePosition) {
    // The same cube as two meshes: five faces, and the lid with vertices of its own. Only the first knows the creases.
    scene::Scene scene = cube();
    crease_ring(scene, 10.0f);
    scene.meshes.push_back(scene.meshes[0]);
    scene.meshes[1].tags = {};
    scene.meshes[1].quads = {4, 5, 6, 7};
    scene.meshes[0].quads.erase(scene.meshes[0].quads.begin() + 4, scene.meshes[0].quads.begin() + 8);
    const PatchSet set = make_patches(scene);
    EXPECT_EQ(normal(set.corner_tags[5][0]), glm::vec3(0, 0, 1));
    EXPECT_EQ(set.corner_tags[5][0].edge, 1.0f);
    EXPECT_EQ(std::memcmp(&set.vertex_tags[4], &set.vertex_tags[8 + 4], sizeof(VertexTags)), 0);
}

// A pole where a hundred creases meet.
TEST(SurfaceTags, ManyCreasesAtOneVertex) {
    scene::Scene scene;
    scene.materials.resize(1);
    scene::Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions.push_back({0, 0, 1});
    constexpr std::uint32_t count = 100;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float a = 6.2831853f * static_cast<float>(i) / count;
        mesh.positions.push_back({std::cos(a), std::sin(a), 0});
        mesh.triangles.insert(mesh.triangles.end(), {0, 1 + i, 1 + (i + 1) % count});
        mesh.tags.creases.push_back({0, 1 + i, 1.0f});
    }
    mesh.normals.assign(count + 1, {0, 0, 1});
    mesh.uvs.assign(count + 1, glm::vec2(0.0f));
    const PatchSet set = make_patches(scene);
    for (const auto& tags : set.corner_tags)
        EXPECT_NEAR(normal(tags[0]).z, std::sqrt(0.5f), 1e-3f) << "each face stands alone";
}

}  // namespace
}  // namespace tessera::patches
