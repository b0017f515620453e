// COLOR_0 and TANGENT: what is read, how nodes move it, and what is refused.
#include "scene/gltf_builder.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace tessera::test {
namespace {

using json = GltfBuilder::json;

constexpr float beyond = std::numeric_limits<float>::infinity();

/// A triangle facing +z with an attribute. The builder writes no "normalized" by itself.
template <typename T>
GltfBuilder with(const char* name, const std::string& type, int component, const std::vector<T>& values,
                 bool normalized = false) {
    GltfBuilder builder;
    const int positions = builder.add_positions(triangle_positions);
    const int normals = builder.add_positions({0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int accessor = builder.add(type, component, values);
    if (normalized) builder.document["accessors"][static_cast<std::size_t>(accessor)]["normalized"] = true;
    builder.add_mesh_node({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {name, accessor}}}});
    return builder;
}

const std::vector<float> along_x{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1};

TEST(VertexColours, OfThreeOrFourNumbers) {
    const auto rgb = with<float>("COLOR_0", "VEC3", 5126, {1, 0, 0, 0, 0.5f, 0, 0, 0, 0.25f}).load();
    expect_sound(rgb);
    EXPECT_EQ(rgb.meshes.at(0).colors, (std::vector<glm::vec4>{{1, 0, 0, 1}, {0, 0.5f, 0, 1}, {0, 0, 0.25f, 1}}));
    EXPECT_TRUE(rgb.messages.empty());
    const auto rgba = with<float>("COLOR_0", "VEC4", 5126, {1, 0, 0, 0, 0, 1, 0, 0.5f, 0, 0, 1, 1}).load();
    EXPECT_EQ(rgba.meshes.at(0).colors, (std::vector<glm::vec4>{{1, 0, 0, 0}, {0, 1, 0, 0.5f}, {0, 0, 1, 1}}));
}

TEST(VertexColours, OfNormalisedIntegersAreLinear) {
    const auto bytes =
        with<std::uint8_t>("COLOR_0", "VEC4", 5121, {255, 51, 0, 102, 0, 0, 0, 255, 255, 255, 255, 0}, true).load();
    ASSERT_EQ(bytes.meshes.at(0).colors.size(), 3u);
    EXPECT_EQ(bytes.meshes[0].colors[0], glm::vec4(1.0f, 0.2f, 0.0f, 0.4f));
    const auto shorts =
        with<std::uint16_t>("COLOR_0", "VEC4", 5123, std::vector<std::uint16_t>(12, 13107), true).load();
    EXPECT_EQ(shorts.meshes.at(0).colors[2], glm::vec4(0.2f));
}

TEST(VertexColours, OutOfRangeAreClampedAndCounted) {
    const auto scene = with<float>("COLOR_0", "VEC3", 5126, {2, -1, 0.5f, NAN, beyond, 0, 0, 0, 0}).load();
    EXPECT_EQ(scene.meshes.at(0).colors[0], glm::vec4(1, 0, 0.5f, 1));
    EXPECT_EQ(scene.meshes[0].colors[1], glm::vec4(1, 1, 0, 1));
    EXPECT_TRUE(has_message(scene, "2 values of COLOR_0 are outside"));
    EXPECT_TRUE(has_message(scene, "2 values of COLOR_0 are not finite"));
}

TEST(VertexColours, OfOtherFormatsAreRefused) {
    const auto refused = [](const GltfBuilder& builder) { return refusal(builder); };
    EXPECT_NE(refused(with<float>("COLOR_0", "VEC2", 5126, std::vector<float>(6, 0))).find("COLOR_0"),
              std::string::npos);
    EXPECT_NE(refused(with<std::int8_t>("COLOR_0", "VEC4", 5120, std::vector<std::int8_t>(12, 0), true))
                  .find("must be a VEC3 or VEC4"),
              std::string::npos);
    EXPECT_NE(
        refused(with<std::uint8_t>("COLOR_0", "VEC4", 5121, std::vector<std::uint8_t>(12, 0))).find("not normalised"),
        std::string::npos);
    EXPECT_NE(refused(with<float>("COLOR_0", "VEC4", 5126, std::vector<float>(16, 0))).find("has 4 elements"),
              std::string::npos);
    EXPECT_NE(refused(with<float>("COLOR_1", "VEC2", 5126, std::vector<float>(6, 0))).find("COLOR_1"),
              std::string::npos);
}

TEST(VertexColours, FollowTheVerticesThatStayAndSmoothNormals) {
    GltfBuilder builder;
    const int positions = builder.add_positions({beyond, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int colours = builder.add("VEC3", 5126, std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    const int indices = builder.add("SCALAR", 5123, std::vector<std::uint16_t>{0, 1, 2, 1, 2, 3});
    builder.add_mesh_node({{"attributes", {{"POSITION", positions}, {"COLOR_0", colours}}}, {"indices", indices}});
    const std::vector<glm::vec4> expected{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
    EXPECT_EQ(builder.load().meshes.at(0).colors, expected);
    const TemporaryFolder folder;
    const auto file = folder.write("model.gltf", builder.text()).string();
    EXPECT_EQ(scene::load_scene(file, {.smooth_normals = true}).meshes.at(0).colors, expected);
}

TEST(FileTangents, GoWithTheNode) {
    auto builder = with<float>("TANGENT", "VEC4", 5126, along_x);
    builder.document["nodes"][0]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};  // x to y
    builder.document["nodes"][0]["scale"] = {3, 1, 1};
    const auto mesh = builder.load().meshes.at(0);
    ASSERT_EQ(mesh.tangents.size(), 3u);
    EXPECT_NEAR(glm::distance(mesh.tangents[1], glm::vec4(0, 1, 0, 1)), 0.0f, 1e-6f);
}

// The bitangent of a mirrored node points where the mirrored bitangent does.
TEST(FileTangents, KeepTheirBitangentInAMirror) {
    for (const std::array<double, 3>& scale : {std::array{-1.0, 1.0, 1.0}, {1.0, -2.0, 1.0}, {1.0, 1.0, -1.0}}) {
        auto builder = with<float>("TANGENT", "VEC4", 5126, along_x);
        builder.document["nodes"][0]["scale"] = scale;
        const auto mesh = builder.load().meshes.at(0);
        ASSERT_EQ(mesh.tangents.size(), 3u);
        const glm::vec3 tangent(mesh.tangents[0]);
        const glm::vec3 bitangent = mesh.tangents[0].w * glm::cross(mesh.normals[0], tangent);
        EXPECT_EQ(tangent.x, scale[0] < 0 ? -1.0f : 1.0f);
        EXPECT_EQ(bitangent.y, scale[1] < 0 ? -1.0f : 1.0f);
        EXPECT_EQ(mesh.tangents[0].w, -1.0f);
    }
}

TEST(FileTangents, OfNoUseAreLeftOutAsAWhole) {
    for (const auto& [place, value] : {std::pair{4, 0.0f}, {8, NAN}, {7, 0.5f}, {11, beyond}}) {
        auto values = along_x;
        values[static_cast<std::size_t>(place)] = value;
        const auto scene = with<float>("TANGENT", "VEC4", 5126, values).load();
        EXPECT_TRUE(scene.meshes.at(0).tangents.empty()) << place;
        EXPECT_TRUE(has_message(scene, "1 tangents are zero, not finite")) << place;
    }
    GltfBuilder builder;
    const int positions = builder.add_positions(triangle_positions);
    const int tangents = builder.add("VEC4", 5126, along_x);
    builder.add_mesh_node({{"attributes", {{"POSITION", positions}, {"TANGENT", tangents}}}});
    EXPECT_TRUE(builder.load().meshes.at(0).tangents.empty());
    EXPECT_TRUE(has_message(builder.load(), "has no NORMAL"));
}

TEST(FileTangents, AreMorphed) {
    auto builder = with<float>("TANGENT", "VEC4", 5126, along_x);
    const int turned = builder.add_positions({-1, 1, 0, -1, 1, 0, -1, 1, 0});
    builder.document["meshes"][0]["primitives"][0]["targets"] = json::array({{{"TANGENT", turned}}});
    builder.document["meshes"][0]["weights"] = {1.0};
    EXPECT_EQ(builder.load().meshes.at(0).tangents.at(2), glm::vec4(0, 1, 0, 1));
}

TEST(FileTangents, OfOtherFormatsAreRefused) {
    EXPECT_NE(refusal(with<float>("TANGENT", "VEC3", 5126, std::vector<float>(9, 1))).find("must be a VEC4"),
              std::string::npos);
    EXPECT_NE(
        refusal(with<std::int16_t>("TANGENT", "VEC4", 5122, std::vector<std::int16_t>(12, 1))).find("not normalised"),
        std::string::npos);
    EXPECT_NE(refusal(with<float>("TANGENT", "VEC4", 5126, std::vector<float>(8, 1))).find("has 2 elements"),
              std::string::npos);
}

}  // namespace
}  // namespace tessera::test
