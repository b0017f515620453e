// Transforms, hierarchy and skins.
#include "scene/gltf_builder.hpp"

#include <cmath>
#include <cstdint>

namespace tessera::test {
namespace {

using json = nlohmann::json;

/// A triangle with normals along +z.
GltfBuilder triangle_with_normals() {
    GltfBuilder builder;
    const int positions = builder.add_positions(triangle_positions);
    const int normals = builder.add_positions({0, 0, 1, 0, 0, 1, 0, 0, 1});
    builder.add_mesh_node({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
    return builder;
}

glm::vec3 face_normal(const scene::Mesh& mesh) {
    const auto p = [&](std::size_t i) { return mesh.positions[mesh.triangles[i]]; };
    return glm::normalize(glm::cross(p(1) - p(0), p(2) - p(0)));
}

void expect_near(const glm::vec3& a, const glm::vec3& b) {
    EXPECT_LT(glm::length(a - b), 1e-6f) << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " "
                                         << b.z;
}

TEST(Nodes, TransformsAreAppliedFromTheRootDown) {
    GltfBuilder builder = triangle_with_normals();
    const double half = std::sqrt(0.5);
    builder.document["nodes"][0]["translation"] = {0, 0, 1};
    // A quarter turn around x takes y to z and z to -y; the outer node doubles and shifts.
    builder.push("nodes", {{"children", {0}}, {"rotation", {half, 0, 0, half}}});
    builder.push("nodes", {{"children", {1}}, {"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 10, 0, 0, 1}}});
    const scene::Scene scene = builder.load();
    expect_near(scene.meshes.at(0).positions[0], {10, -2, 0});
    expect_near(scene.meshes[0].positions[2], {10, -2, 2});
    expect_near(scene.meshes[0].normals[0], {0, -1, 0});
}

TEST(Nodes, MirrorsTurnTheWindingAndKeepNormalsOnTheFront) {
    for (const auto& scale : {glm::vec3(-1, 1, 1), glm::vec3(1, 1, -1), glm::vec3(-1, -1, 1), glm::vec3(-2, -3, -4)}) {
        GltfBuilder builder = triangle_with_normals();
        builder.document["nodes"][0]["scale"] = {scale.x, scale.y, scale.z};
        const scene::Mesh mesh = builder.load().meshes.at(0);
        expect_near(face_normal(mesh), mesh.normals[0]);
    }
}

TEST(Nodes, NormalsGoByTheInverseTranspose) {
    GltfBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, -1, 0, 0, 0, 1});
    const float s = std::sqrt(0.5f);
    const int normals = builder.add_positions({s, s, 0, s, s, 0, s, s, 0});
    builder.add_mesh_node({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                           {"indices", builder.add("SCALAR", 5121, std::vector<std::uint8_t>{0, 2, 1})}});
    builder.document["nodes"][0]["scale"] = {1, 4, 1};
    const scene::Mesh mesh = builder.load().meshes.at(0);
    expect_near(mesh.normals[0], glm::normalize(glm::vec3(4, 1, 0)));
    expect_near(face_normal(mesh), mesh.normals[0]);
}

TEST(Nodes, AFlattenedMeshKeepsItsNormalAndAVanishedOneIsLeftOut) {
    GltfBuilder flat = triangle_with_normals();
    flat.document["nodes"][0]["scale"] = {1, 1, 0};
    expect_near(flat.load().meshes.at(0).normals[0], {0, 0, 1});

    GltfBuilder line = triangle_with_normals();
    line.document["nodes"][0]["scale"] = {1, 0, 0};
    const scene::Scene scene = line.load();
    EXPECT_TRUE(scene.meshes.empty());
    EXPECT_TRUE(has_message(scene, "nodes[0]: its transform leaves no surface"));
}

TEST(Nodes, TinyAndHugeScalesKeepNormals) {
    for (const double scale : {1e-30, 1e30}) {
        GltfBuilder builder = triangle_with_normals();
        builder.document["nodes"][0]["scale"] = {scale, -scale, scale};
        const scene::Mesh mesh = builder.load().meshes.at(0);
        expect_near(mesh.normals[0], {0, 0, 1});
        EXPECT_EQ(mesh.triangles, (std::vector<std::uint32_t>{0, 2, 1}));
    }
}

TEST(Nodes, TheDefaultSceneIsShownElseTheFirstElseAllRoots) {
    GltfBuilder builder = triangle_with_normals();
    builder.push("nodes", {{"mesh", 0}, {"translation", {5, 0, 0}}, {"name", "second"}});
    EXPECT_EQ(builder.load().meshes.size(), 2u);
    builder.push("scenes", {{"nodes", {0}}});
    builder.push("scenes", {{"nodes", {1}}});
    EXPECT_EQ(builder.load().meshes.at(0).positions[0].x, 0.0f);
    builder.document["scene"] = 1;
    const scene::Scene scene = builder.load();
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].positions[0].x, 5.0f);
    EXPECT_EQ(scene.meshes[0].name, "second");
}

TEST(Nodes, ANodeListedAgainIsDrawnOnceWhereItsParentPutsIt) {
    GltfBuilder builder = triangle_with_normals();
    builder.push("nodes", {{"children", {0}}, {"translation", {7, 0, 0}}});
    for (const json& listed : {json{0, 1}, json{1, 0}, json{1, 1, 0}}) {
        builder.document["scenes"] = json::array({{{"nodes", listed}}});
        const scene::Scene scene = builder.load();
        ASSERT_EQ(scene.meshes.size(), 1u);
        EXPECT_EQ(scene.meshes[0].positions[0].x, 7.0f);
        EXPECT_TRUE(has_message(scene, "nodes[0], which is a child of nodes[1]"));
    }
}

TEST(Nodes, CyclesAndSecondParentsAreRefused) {
    GltfBuilder loop = triangle_with_normals();
    loop.document["nodes"][0]["children"] = {0};
    EXPECT_NE(refusal(loop).find("nodes[0] is on a cycle"), std::string::npos);

    GltfBuilder twice = triangle_with_normals();
    twice.push("nodes", {{"children", {0}}});
    twice.push("nodes", {{"children", {0}}});
    EXPECT_NE(refusal(twice).find("nodes[0] is a child twice"), std::string::npos);
}

TEST(Nodes, AChainAsDeepAsTheFileAllowsIsWalked) {
    GltfBuilder builder = triangle_with_normals();
    constexpr int depth = 100'000;
    for (int i = 0; i < depth; ++i)
        builder.document["nodes"].push_back({{"children", {i}}, {"translation", {1, 0, 0}}});
    EXPECT_EQ(builder.load().meshes.at(0).positions[0].x, static_cast<float>(depth));
}

/// A triangle whose first two vertices follow joint 0 and whose last follows both, with weights that sum to 4.
GltfBuilder skinned_triangle() {
    GltfBuilder builder;
    const int positions = builder.add_positions(triangle_positions);
    const int normals = builder.add_positions({0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int joints = builder.add("VEC4", 5121, std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0});
    const int weights = builder.add("VEC4", 5126, std::vector<float>{1, 0, 0, 0, 2, 0, 0, 0, 1, 3, 0, 0});
    builder.add_mesh_node(
        {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}}});
    builder.document["nodes"][0]["skin"] = 0;
    builder.document["nodes"][0]["translation"] = {100, 100, 100};  // a skinned mesh does not follow its node
    builder.push("nodes", {{"translation", {1, 0, 0}}});
    builder.push("nodes", {{"translation", {1, 0, 4}}});
    const std::vector<float> back{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1};
    std::vector<float> matrices = back;
    matrices.insert(matrices.end(), back.begin(), back.end());
    builder.push("skins", {{"joints", {1, 2}}, {"inverseBindMatrices", builder.add("MAT4", 5126, matrices)}});
    return builder;
}

TEST(Skins, TheRestPoseBlendsJointsByNormalisedWeights) {
    const scene::Scene scene = skinned_triangle().load();
    expect_sound(scene);
    const scene::Mesh& mesh = scene.meshes.at(0);
    expect_near(mesh.positions[0], {0, 0, 0});
    expect_near(mesh.positions[1], {1, 0, 0});
    expect_near(mesh.positions[2], {0, 1, 3});
    expect_near(mesh.normals[2], {0, 0, 1});
}

TEST(Skins, MirroringJointsTurnTheWinding) {
    GltfBuilder builder = skinned_triangle();
    builder.document["nodes"][1]["scale"] = {-1, 1, 1};
    builder.document["nodes"][2]["scale"] = {-1, 1, 1};
    EXPECT_EQ(builder.load().meshes.at(0).triangles, (std::vector<std::uint32_t>{0, 2, 1}));
}

TEST(Skins, VerticesWithoutWeightFollowTheirFirstJoint) {
    GltfBuilder builder = skinned_triangle();
    const int weights = builder.add("VEC4", 5126, std::vector<float>(12, 0.0f));
    builder.document["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = weights;
    const scene::Scene scene = builder.load();
    expect_near(scene.meshes.at(0).positions[1], {1, 0, 0});
    EXPECT_TRUE(has_message(scene, "3 vertices have no skin weight"));
}

TEST(Skins, AJointThatTheSkinLacksIsRefused) {
    GltfBuilder builder = skinned_triangle();
    builder.document["skins"][0]["joints"] = {1};
    EXPECT_NE(refusal(builder).find("names joint 1, but the skin has 1"), std::string::npos);
}

TEST(Skins, AMeshWithoutJointsFollowsItsNode) {
    GltfBuilder builder = triangle_with_normals();
    builder.document["nodes"][0]["translation"] = {3, 0, 0};
    builder.document["nodes"][0]["skin"] = builder.push("skins", {{"joints", {0}}});
    const scene::Scene scene = builder.load();
    expect_near(scene.meshes.at(0).positions[0], {3, 0, 0});
    EXPECT_TRUE(has_message(scene, "no JOINTS_0"));
}

}  // namespace
}  // namespace tessera::test
