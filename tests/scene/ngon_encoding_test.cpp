// FB_ngon_encoding: quads come back out of triangle lists.
#include "scene/gltf_builder.hpp"

namespace tessera::test {
namespace {

using Indices = std::vector<std::uint32_t>;

scene::Mesh load(const std::vector<std::uint16_t>& indices, bool encoded, const std::vector<float>& scale = {1, 1, 1}) {
    GltfBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0});
    const int list = builder.add("SCALAR", 5123, indices);
    GltfBuilder::json primitive{{"attributes", {{"POSITION", positions}}}, {"indices", list}};
    if (encoded) primitive["extensions"] = {{"FB_ngon_encoding", GltfBuilder::json::object()}};
    builder.document["extensionsUsed"] = {"FB_ngon_encoding"};
    const int node = builder.add_mesh_node(std::move(primitive));
    builder.document["nodes"][static_cast<std::size_t>(node)]["scale"] = scale;
    const auto scene = builder.load();
    expect_sound(scene);
    return scene.meshes.at(0);
}

TEST(NgonEncoding, TwoTrianglesWithTheSameFirstIndexAreAQuad) {
    // A quad, a triangle, a quad.
    const auto mesh = load({0, 1, 2, 0, 2, 3, 1, 4, 2, 4, 5, 2, 4, 2, 1}, true);
    EXPECT_EQ(mesh.quads, (Indices{0, 1, 2, 3, 4, 5, 2, 1}));
    EXPECT_EQ(mesh.triangles, (Indices{1, 4, 2}));
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
}

TEST(NgonEncoding, WithoutTheExtensionTrianglesStay) {
    const auto mesh = load({0, 1, 2, 0, 2, 3}, false);
    EXPECT_TRUE(mesh.quads.empty());
    EXPECT_EQ(mesh.triangles.size(), 6u);
}

TEST(NgonEncoding, LargerPolygonsAndOtherPairsStayTriangles) {
    EXPECT_TRUE(load({0, 1, 4, 0, 4, 5, 0, 5, 3}, true).quads.empty());
    EXPECT_TRUE(load({0, 1, 2, 0, 3, 5}, true).quads.empty());
    EXPECT_TRUE(load({0, 1, 2, 0, 2, 1}, true).quads.empty()) << "front and back of one triangle";
}

TEST(NgonEncoding, MirroredNodesTurnQuadsRound) {
    const auto mesh = load({0, 1, 2, 0, 2, 3}, true, {-1, 1, 1});
    EXPECT_EQ(mesh.quads, (Indices{0, 3, 2, 1}));
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace tessera::test
