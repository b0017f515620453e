// Lines of glTF files as guide curves of hair.
#include "scene/gltf_builder.hpp"

#include <cmath>
#include <limits>

namespace tessera::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// A node with one primitive of lines over `positions`.
scene::Scene load_lines(int mode, const std::vector<float>& positions, const std::vector<std::uint32_t>& indices = {},
                        const std::vector<float>& widths = {}) {
    GltfBuilder builder;
    nlohmann::json primitive{{"attributes", {{"POSITION", builder.add_positions(positions)}}}, {"mode", mode}};
    if (!widths.empty()) primitive["attributes"]["_WIDTH"] = builder.add("SCALAR", 5126, widths);
    if (!indices.empty()) primitive["indices"] = builder.add("SCALAR", 5125, indices);
    builder.add_mesh_node(primitive);
    return builder.load();
}

TEST(Guides, ALineStripIsOneInWorldSpace) {
    GltfBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 1, 1, 0});
    const int normals = builder.add_positions({0, 0, 1, 0, 0, 1, 0, 3, 4});
    const int widths = builder.add("SCALAR", 5126, std::vector<float>{0.5f, 0.25f, 0.0f});
    builder.add_mesh_node(
        {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"_WIDTH", widths}}}, {"mode", 3}});
    builder.document["nodes"][0]["scale"] = {2, 2, 2};
    builder.document["nodes"][0]["translation"] = {0, 0, 5};
    builder.document["nodes"][0]["name"] = "head";
    const scene::Scene scene = builder.load();
    EXPECT_TRUE(scene.messages.empty()) << scene.messages.front();
    EXPECT_TRUE(scene.meshes.empty());
    ASSERT_EQ(scene.guides.size(), 1u);
    const scene::Guides& guides = scene.guides[0];
    EXPECT_EQ(guides.name, "head/hair");
    EXPECT_EQ(guides.points, (std::vector<glm::vec3>{{0, 0, 5}, {2, 0, 5}, {2, 2, 5}}));
    EXPECT_EQ(guides.ends, std::vector<std::uint32_t>{3});
    ASSERT_EQ(guides.widths.size(), 3u);
    EXPECT_NEAR(guides.widths[0], 1.0f, 1e-6f);
    EXPECT_NEAR(guides.widths[1], 0.5f, 1e-6f);
    EXPECT_EQ(guides.widths[2], 0.0f);
    EXPECT_NEAR(guides.normals[2].y, 0.6f, 1e-6f);
    EXPECT_NEAR(guides.normals[2].z, 0.8f, 1e-6f);
    EXPECT_TRUE(scene.materials.at(guides.material).double_sided);
    expect_sound(scene);
}

TEST(Guides, LinesThatFollowOneAnotherMakeOneCurve) {
    const std::vector<float> positions{0, 0, 0, 0, 1, 0, 0, 2, 0, 1, 0, 0, 1, 1, 0};
    const scene::Scene scene = load_lines(1, positions, {0, 1, 1, 2, 3, 4});
    ASSERT_EQ(scene.guides.size(), 1u);
    EXPECT_EQ(scene.guides[0].ends, (std::vector<std::uint32_t>{3, 5}));
    EXPECT_EQ(scene.guides[0].points[2], glm::vec3(0, 2, 0));
    EXPECT_EQ(scene.guides[0].widths, std::vector<float>(5, scene::no_width));
    EXPECT_TRUE(has_message(load_lines(1, positions, {0, 1, 1}), "3 indices, not a multiple of two"));
}

TEST(Guides, PrimitivesOfANodeWithOneMaterialBelongTogether) {
    GltfBuilder builder;
    const int first = builder.add_positions({0, 0, 0, 0, 1, 0});
    const int second = builder.add_positions({1, 0, 0, 1, 1, 0});
    builder.document["materials"] = {{{"name", "plain"}}, {{"name", "both"}, {"doubleSided", true}}};
    nlohmann::json primitives;
    for (const int material : {0, 1, 0}) {
        primitives.push_back({{"attributes", {{"POSITION", primitives.size() == 2 ? second : first}}},
                              {"mode", 3},
                              {"material", material}});
    }
    builder.push("meshes", {{"primitives", primitives}});
    builder.push("nodes", {{"mesh", 0}});
    const scene::Scene scene = builder.load();
    ASSERT_EQ(scene.guides.size(), 2u);
    EXPECT_EQ(scene.guides[0].ends, (std::vector<std::uint32_t>{2, 4}));
    EXPECT_EQ(scene.guides[1].ends, std::vector<std::uint32_t>{2});
    EXPECT_EQ(scene.materials[scene.guides[0].material].name, "plain");
    EXPECT_TRUE(scene.materials[scene.guides[0].material].double_sided);
    EXPECT_FALSE(scene.materials[0].double_sided) << "the meshes' own is as it was";
    EXPECT_EQ(scene.guides[1].material, 1u);
}

TEST(Guides, UnsoundOnesAreDroppedAndCounted) {
    const scene::Scene repeated = load_lines(3, {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 2, 0});
    ASSERT_EQ(repeated.guides.size(), 1u);
    EXPECT_EQ(repeated.guides[0].points.size(), 3u);
    EXPECT_TRUE(has_message(repeated, "2 points of guide curves repeat the one before"));

    const scene::Scene collapsed = load_lines(3, {1, 2, 3, 1, 2, 3, 1, 2, 3});
    EXPECT_TRUE(collapsed.guides.empty());
    EXPECT_TRUE(has_message(collapsed, "1 guide curves have no two different points"));
    EXPECT_TRUE(has_message(collapsed, "no triangles"));

    const scene::Scene single = load_lines(3, {1, 2, 3});
    EXPECT_TRUE(single.guides.empty());
    EXPECT_TRUE(has_message(single, "is a line of 1 points and is skipped"));

    const scene::Scene unsound = load_lines(1, {0, 0, 0, 0, 1, 0, nan, 0, 0, 1, 1, 0}, {0, 1, 2, 3});
    ASSERT_EQ(unsound.guides.size(), 1u);
    EXPECT_EQ(unsound.guides[0].ends, std::vector<std::uint32_t>{2});
    EXPECT_TRUE(has_message(unsound, "1 guide curves have positions that are not finite"));

    std::vector<float> line;
    for (int i = 0; i < 5000; ++i)
        line.insert(line.end(), {0.0f, static_cast<float>(i), 0.0f});
    const scene::Scene long_one = load_lines(3, line);
    EXPECT_TRUE(long_one.guides.empty());
    EXPECT_TRUE(has_message(long_one, "more than 4096 points"));

    const scene::Scene widths = load_lines(3, {0, 0, 0, 0, 1, 0, 0, 2, 0}, {}, {1.0f, -1.0f, nan});
    EXPECT_EQ(widths.guides.at(0).widths, (std::vector<float>{1.0f, 0.0f, 0.0f}));
    EXPECT_TRUE(has_message(widths, "2 widths are negative or not finite"));
}

TEST(Guides, PointsAndLoopsAreSkippedAsEver) {
    const std::vector<float> positions{0, 0, 0, 0, 1, 0, 1, 1, 0};
    EXPECT_TRUE(has_message(load_lines(0, positions), "meshes[0].primitives[0] is made of points, which are skipped."));
    EXPECT_TRUE(has_message(load_lines(2, positions), "meshes[0].primitives[0] is made of lines, which are skipped."));
    EXPECT_TRUE(load_lines(2, positions).guides.empty());
}

}  // namespace
}  // namespace tessera::test
