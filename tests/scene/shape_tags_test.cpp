// Attributes and extras that shape the surface: _ALPHA, _STPN, the alpha of a mesh.
#include "scene/gltf_builder.hpp"

#include <limits>

namespace tessera::test {
namespace {

using json = GltfBuilder::json;

constexpr float infinity = std::numeric_limits<float>::infinity();

template <typename T>
scene::Scene load_with(const char* name, const std::string& type, int component, const std::vector<T>& values,
                       const json& extras = {}, bool normalized = false) {
    GltfBuilder builder;
    const int positions = builder.add_positions(triangle_positions);
    const int accessor = builder.add(type, component, values);
    if (normalized) builder.document["accessors"][static_cast<std::size_t>(accessor)]["normalized"] = true;
    builder.add_mesh_node({{"attributes", {{"POSITION", positions}, {name, accessor}}}});
    if (!extras.is_null()) builder.document["meshes"][0]["extras"] = extras;
    return builder.load();
}

scene::Scene load_with_extras(const json& extras) {
    return load_with<float>("_OTHER", "SCALAR", 5126, {1, 2, 3}, extras);
}

TEST(ShapeTags, AlphaOfEachVertex) {
    const auto scene = load_with<float>("_ALPHA", "SCALAR", 5126, {0.0f, 0.25f, 1.0f});
    EXPECT_EQ(scene.meshes.at(0).alphas, (std::vector<float>{0.0f, 0.25f, 1.0f}));
    EXPECT_TRUE(scene.meshes[0].stpn.empty());
    EXPECT_TRUE(scene.messages.empty());
}

TEST(ShapeTags, NormalisedIntegersAreShares) {
    const auto bytes = load_with<std::uint8_t>("_ALPHA", "SCALAR", 5121, {0, 51, 255}, {}, true);
    EXPECT_EQ(bytes.meshes.at(0).alphas, (std::vector<float>{0.0f, 0.2f, 1.0f}));
    const auto plain = load_with<std::uint16_t>("_ALPHA", "SCALAR", 5123, {0, 1, 0});
    EXPECT_EQ(plain.meshes.at(0).alphas, (std::vector<float>{0.0f, 1.0f, 0.0f}));
}

TEST(ShapeTags, ValuesOutOfRangeAreClampedAndCounted) {
    const auto scene = load_with<float>("_ALPHA", "SCALAR", 5126, {-0.5f, 2.0f, infinity});
    EXPECT_EQ(scene.meshes.at(0).alphas, (std::vector<float>{0.0f, 1.0f, 0.0f}));
    EXPECT_TRUE(has_message(scene, "2 values are out of range"));
    EXPECT_TRUE(has_message(scene, "1 values are not finite"));
}

TEST(ShapeTags, TagsOfPnTriangles) {
    const auto scene = load_with<float>("_STPN", "VEC3", 5126, {0, 0, 0, 1, -1, 0.5f, -1, 3, -3});
    const std::vector<glm::vec3> expected{{0, 0, 0}, {1, -1, 0.5f}, {0, 1, -1}};
    EXPECT_EQ(scene.meshes.at(0).stpn, expected);
    EXPECT_TRUE(has_message(scene, "3 values are out of range"));
}

TEST(ShapeTags, OtherTypesAreLeftOut) {
    const auto alpha = load_with<float>("_ALPHA", "VEC2", 5126, {0, 0, 0, 0, 0, 0});
    EXPECT_TRUE(alpha.meshes.at(0).alphas.empty());
    EXPECT_TRUE(has_message(alpha, "its _ALPHA is not a SCALAR"));
    const auto stpn = load_with<float>("_STPN", "SCALAR", 5126, {0, 0, 0});
    EXPECT_TRUE(stpn.meshes.at(0).stpn.empty());
    EXPECT_TRUE(has_message(stpn, "its _STPN is not a VEC3"));
}

TEST(ShapeTags, ExtrasGiveTheMeshAnAlpha) {
    EXPECT_EQ(load_with_extras({{"alpha", 0.5}}).meshes.at(0).alphas, (std::vector<float>{0.5f, 0.5f, 0.5f}));
    const auto clamped = load_with_extras({{"alpha", 1e300}});
    EXPECT_EQ(clamped.meshes.at(0).alphas, (std::vector<float>{1.0f, 1.0f, 1.0f}));
    EXPECT_TRUE(has_message(clamped, "out of range"));
    // The attribute goes first.
    const auto both = load_with<float>("_ALPHA", "SCALAR", 5126, {0, 0.25f, 1}, {{"alpha", 0.5}});
    EXPECT_EQ(both.meshes.at(0).alphas, (std::vector<float>{0, 0.25f, 1}));
}

TEST(ShapeTags, ExtrasMayBeAnything) {
    for (const json& extras :
         {json("alpha"), json::array({1, 2}), json(3), json{{"alpha", "half"}}, json{{"beta", 1}}}) {
        EXPECT_TRUE(load_with_extras(extras).meshes.at(0).alphas.empty()) << extras;
    }
}

TEST(ShapeTags, FollowTheVerticesThatStay) {
    GltfBuilder builder;
    const int positions = builder.add_positions({infinity, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int alphas = builder.add("SCALAR", 5126, std::vector<float>{0.1f, 0.2f, 0.3f, 0.4f});
    const int tags = builder.add("VEC3", 5126, std::vector<float>{1, 0, 0, 0.2f, 0, 0, 0.3f, 0, 0, 0.4f, 0, 0});
    const int indices = builder.add("SCALAR", 5123, std::vector<std::uint16_t>{0, 1, 2, 1, 2, 3});
    builder.add_mesh_node(
        {{"attributes", {{"POSITION", positions}, {"_ALPHA", alphas}, {"_STPN", tags}}}, {"indices", indices}});
    const auto mesh = builder.load().meshes.at(0);
    EXPECT_EQ(mesh.alphas, (std::vector<float>{0.2f, 0.3f, 0.4f}));
    ASSERT_EQ(mesh.stpn.size(), 3u);
    EXPECT_EQ(mesh.stpn[2].x, 0.4f);
}

}  // namespace
}  // namespace tessera::test
