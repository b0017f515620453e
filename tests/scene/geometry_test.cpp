// Positions, triangles and attributes of primitives, in files built here.
#include "scene/gltf_builder.hpp"

#include <cmath>
#include <cstdint>

namespace tessera::test {
namespace {

using json = nlohmann::json;

/// Four corners of the unit square in the order of a strip.
const std::vector<float> strip_positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

std::vector<std::uint32_t> triangles_of(int mode, const std::vector<std::uint32_t>& indices) {
    GltfBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0, 2, 2, 0});
    builder.add_mesh_node(
        {{"attributes", {{"POSITION", positions}}}, {"indices", builder.add("SCALAR", 5125, indices)}, {"mode", mode}});
    const scene::Scene scene = builder.load();
    expect_sound(scene);
    return scene.meshes.empty() ? std::vector<std::uint32_t>{} : scene.meshes[0].triangles;
}

using Indices = std::vector<std::uint32_t>;

TEST(Geometry, ListsStripsAndFansTurnTheSameWay) {
    EXPECT_EQ(triangles_of(4, {0, 1, 2, 2, 1, 3}), (Indices{0, 1, 2, 2, 1, 3}));
    EXPECT_EQ(triangles_of(5, {0, 1, 2, 3, 4}), (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
    EXPECT_EQ(triangles_of(6, {0, 1, 2, 3}), (Indices{1, 2, 0, 2, 3, 0}));
}

TEST(Geometry, StripsMayJumpOverCollapsedTriangles) {
    EXPECT_EQ(triangles_of(5, {0, 1, 2, 2, 3, 3, 4, 5}), (Indices{0, 1, 2, 3, 5, 4}));
}

TEST(Geometry, IncompleteAndCollapsedTrianglesAreSkippedWithAMessage) {
    GltfBuilder builder;
    const int positions = builder.add_positions(strip_positions);
    builder.add_mesh_node(
        {{"attributes", {{"POSITION", positions}}},
         {"indices", builder.add("SCALAR", 5123, std::vector<std::uint16_t>{0, 1, 2, 1, 1, 3, 2, 3})}});
    const scene::Scene scene = builder.load();
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].triangles, (Indices{0, 1, 2}));
    EXPECT_TRUE(has_message(scene, "multiple of three"));
    EXPECT_TRUE(has_message(scene, "1 triangles that name a vertex twice"));
}

TEST(Geometry, TooFewIndicesAndPointsAndLinesGiveNoTriangles) {
    EXPECT_TRUE(triangles_of(5, {0, 1}).empty());
    for (int mode = 0; mode < 4; ++mode)
        EXPECT_TRUE(triangles_of(mode, {0, 1, 2}).empty());
}

TEST(Geometry, EveryIndexTypeIsReadAndNoneAtAll) {
    for (const int type : {0, 5121, 5123, 5125}) {
        GltfBuilder builder;
        json primitive{{"attributes", {{"POSITION", builder.add_positions(triangle_positions)}}}};
        if (type == 5121) primitive["indices"] = builder.add("SCALAR", type, std::vector<std::uint8_t>{2, 0, 1});
        if (type == 5123) primitive["indices"] = builder.add("SCALAR", type, std::vector<std::uint16_t>{2, 0, 1});
        if (type == 5125) primitive["indices"] = builder.add("SCALAR", type, std::vector<std::uint32_t>{2, 0, 1});
        builder.add_mesh_node(primitive);
        const scene::Scene scene = builder.load(type == 5121 ? "model.glb" : "model.gltf");
        ASSERT_EQ(scene.meshes.size(), 1u);
        EXPECT_EQ(scene.meshes[0].triangles, type == 0 ? (Indices{0, 1, 2}) : (Indices{2, 0, 1}));
        EXPECT_EQ(scene.meshes[0].positions[1], glm::vec3(1, 0, 0));
    }
}

TEST(Geometry, ByteStrideAndSharedViewsAreHonoured) {
    GltfBuilder builder;
    const int positions = builder.add("VEC3", 5126, triangle_positions, 20);
    const int second = builder.push(
        "accessors", {{"bufferView", 0}, {"byteOffset", 4}, {"componentType", 5126}, {"count", 3}, {"type", "VEC2"}});
    builder.add_mesh_node({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", second}}}});
    const scene::Scene scene = builder.load("model.glb");
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].positions[2], glm::vec3(0, 1, 0));
    EXPECT_EQ(scene.meshes[0].uvs[2], glm::vec2(1, 0));
}

TEST(Geometry, SparseValuesReplaceThoseOfTheBaseOrOfZero) {
    for (const bool with_base : {true, false}) {
        GltfBuilder builder;
        const int base = builder.add_positions({5, 5, 5, 1, 0, 0, 5, 5, 5});
        const int indices = builder.add_view(std::vector<std::uint8_t>{0, 2});
        const int values = builder.add_view(std::vector<float>{0, 0, 0, 0, 1, 0});
        json& accessor = builder.document["accessors"][static_cast<std::size_t>(base)];
        if (!with_base) accessor.erase("bufferView");
        accessor["sparse"] = {{"count", 2},
                              {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                              {"values", {{"bufferView", values}}}};
        builder.add_mesh_node({{"attributes", {{"POSITION", base}}}});
        const scene::Scene scene = builder.load();
        ASSERT_EQ(scene.meshes.size(), 1u);
        EXPECT_EQ(scene.meshes[0].positions[0], glm::vec3(0, 0, 0));
        EXPECT_EQ(scene.meshes[0].positions[1], with_base ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 0));
        EXPECT_EQ(scene.meshes[0].positions[2], glm::vec3(0, 1, 0));
    }
}

TEST(Geometry, QuantisedAttributesAreDecodedAndNormalsMadeUnit) {
    GltfBuilder builder;
    const int positions = builder.add("VEC3", 5122, std::vector<std::int16_t>{-300, 0, 0, 300, 0, 0, 0, 300, 0}, 8);
    const int normals = builder.add("VEC3", 5120, std::vector<std::int8_t>{0, 0, 100, 0, 0, -128, 3, 0, 4}, 4);
    const int uvs = builder.add("VEC2", 5123, std::vector<std::uint16_t>{0, 65535, 65535, 0, 13107, 0});
    builder.document["accessors"][static_cast<std::size_t>(normals)]["normalized"] = true;
    builder.document["accessors"][static_cast<std::size_t>(uvs)]["normalized"] = true;
    builder.document["extensionsUsed"] = {"KHR_mesh_quantization"};
    builder.document["extensionsRequired"] = {"KHR_mesh_quantization"};
    builder.add_mesh_node({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}}}});
    const scene::Scene scene = builder.load();
    expect_sound(scene);
    const scene::Mesh& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.positions[0], glm::vec3(-300, 0, 0));
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 0, -1));
    EXPECT_NEAR(mesh.normals[2].x, 0.6f, 1e-6f);
    EXPECT_EQ(mesh.uvs[0], glm::vec2(0, 1));
    EXPECT_FLOAT_EQ(mesh.uvs[2].x, 0.2f);
    EXPECT_TRUE(scene.messages.empty()) << "quantised normals are not unit by nature";
}

TEST(Geometry, UnsoundPositionsGoWithTheirTriangles) {
    GltfBuilder builder;
    const float nan = std::nanf("");
    const int positions = builder.add_positions({nan, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, INFINITY, 0});
    builder.add_mesh_node(
        {{"attributes", {{"POSITION", positions}}},
         {"indices", builder.add("SCALAR", 5121, std::vector<std::uint8_t>{0, 1, 2, 1, 2, 3, 4, 2, 3})}});
    const scene::Scene scene = builder.load();
    expect_sound(scene);
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].positions.size(), 3u);
    EXPECT_EQ(scene.meshes[0].triangles, (Indices{0, 1, 2}));
    EXPECT_EQ(scene.meshes[0].positions[1], glm::vec3(1, 0, 0));
    EXPECT_TRUE(has_message(scene, "2 positions are not finite; they are left out with the 2 triangles"));
}

TEST(Geometry, PositionsThatOverflowInTheWorldAreUnsoundToo) {
    GltfBuilder builder;
    const int node = builder.add_mesh_node({{"attributes", {{"POSITION", builder.add_positions(triangle_positions)}}}});
    builder.document["nodes"][static_cast<std::size_t>(node)]["scale"] = {1e300, 1, 1};
    EXPECT_NE(refusal(builder).find("no triangle whose positions are all finite"), std::string::npos);
}

TEST(Geometry, MorphTargetsAreTakenAtTheirDefaultWeights) {
    GltfBuilder builder;
    const int positions = builder.add_positions(triangle_positions);
    const int target = builder.add_positions({0, 0, 2, 0, 0, 0, 0, 0, 0});
    builder.add_mesh_node(
        {{"attributes", {{"POSITION", positions}}}, {"targets", json::array({{{"POSITION", target}}})}});
    EXPECT_EQ(builder.load().meshes.at(0).positions[0], glm::vec3(0, 0, 0));
    builder.document["meshes"][0]["weights"] = {0.5};
    EXPECT_EQ(builder.load().meshes.at(0).positions[0], glm::vec3(0, 0, 1));
    builder.document["nodes"][0]["weights"] = {1};
    EXPECT_EQ(builder.load().meshes.at(0).positions[0], glm::vec3(0, 0, 2));
    builder.document["nodes"][0]["weights"] = {1, 2};
    EXPECT_NE(refusal(builder).find("nodes[0].weights has 2 values"), std::string::npos);
}

TEST(Geometry, NegativeZerosBecomePositive) {
    GltfBuilder builder;
    builder.add_mesh_node(
        {{"attributes", {{"POSITION", builder.add_positions({-0.0f, -0.0f, 0, 1, 0, 0, 0, 1, -0.0f})}}}});
    expect_sound(builder.load());
}

}  // namespace
}  // namespace tessera::test
