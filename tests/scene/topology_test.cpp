// What is amiss with faces is counted and said, and the rest stays.
#include "scene/topology.hpp"
#include "scene/gltf_builder.hpp"
#include "scene/obj_files.hpp"

namespace tessera::test {
namespace {

scene::Scene load(const std::vector<float>& positions, const std::vector<std::uint16_t>& indices) {
    GltfBuilder builder;
    const int vertices = builder.add_positions(positions);
    const int list = builder.add("SCALAR", 5123, indices);
    builder.add_mesh_node({{"attributes", {{"POSITION", vertices}}}, {"indices", list}});
    auto scene = builder.load();
    expect_sound(scene);
    return scene;
}

const std::vector<float> five{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0};

TEST(Topology, EdgesOfMoreThanTwoFacesAreCountedAndStay) {
    const auto scene = load(five, {0, 1, 2, 0, 1, 3, 1, 0, 4});
    EXPECT_EQ(scene.meshes.at(0).triangles.size(), 9u);
    EXPECT_TRUE(has_message(scene, "1 edges are used by more than two faces"));
    EXPECT_EQ(scene.messages.size(), 1u);
}

// Seams split vertices, so edges are told by positions.
TEST(Topology, EdgesAreToldByPositions) {
    std::vector<float> split;
    for (const int corner : {0, 1, 2, 0, 1, 3, 1, 0, 4})
        split.insert(split.end(), five.begin() + 3 * corner, five.begin() + 3 * corner + 3);
    EXPECT_TRUE(has_message(load(split, {0, 1, 2, 3, 4, 5, 6, 7, 8}), "1 edges are used by more than two faces"));
    split.resize(18);
    EXPECT_TRUE(load(split, {0, 1, 2, 3, 4, 5}).messages.empty()) << "two faces";
}

// Two nodes that touch are two surfaces.
TEST(Topology, NodesAreLookedAtOneByOne) {
    GltfBuilder builder;
    const int vertices = builder.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    const int list = builder.add("SCALAR", 5123, std::vector<std::uint16_t>{0, 1, 2, 0, 1, 3});
    builder.add_mesh_node({{"attributes", {{"POSITION", vertices}}}, {"indices", list}});
    builder.push("nodes", {{"mesh", 0}});
    const auto scene = builder.load();
    EXPECT_EQ(scene.meshes.size(), 2u);
    EXPECT_TRUE(scene.messages.empty());
}

TEST(Topology, FacesWithoutAreaAreCountedAndStay) {
    // One on a line, one with two corners in one place.
    const auto scene = load({0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0, 0, 0, 0}, {0, 1, 2, 0, 3, 1, 0, 2, 4});
    EXPECT_EQ(scene.meshes.at(0).triangles.size(), 9u);
    EXPECT_TRUE(has_message(scene, "2 faces have no area; they are kept."));
    const auto obj = load_obj_text(square + "v 2 0 0\nv 3 0 0\nf 1 2 3 4\nf 1 2 5\nf 1 2 5 6\n");
    EXPECT_TRUE(has_message(obj, "2 faces have no area; they are kept."));
    EXPECT_EQ(obj.meshes.at(0).quads.size(), 8u);
}

TEST(Topology, RepeatedIndicesAreCountedAndLeftOut) {
    const auto scene = load(five, {0, 1, 2, 0, 0, 3, 1, 4, 1});
    EXPECT_EQ(scene.meshes.at(0).triangles.size(), 3u);
    EXPECT_TRUE(has_message(scene, "2 triangles that name a vertex twice"));
}

TEST(Topology, VerticesWithoutFacesAreCounted) {
    const auto scene = load(five, {0, 1, 2});
    EXPECT_EQ(scene.meshes.at(0).positions.size(), 5u);
    EXPECT_TRUE(has_message(scene, "2 vertices are used by no face."));
    EXPECT_EQ(scene.messages.size(), 1u);
}

TEST(Topology, SoundFacesHaveNoMessage) {
    EXPECT_TRUE(load({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}).messages.empty());
    scene::Mesh quad;
    quad.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    quad.quads = {0, 1, 2, 3};
    EXPECT_EQ(scene::count_flat_faces(std::span(&quad, 1)), 0u);
    EXPECT_EQ(scene::count_crowded_edges(std::span(&quad, 1)), 0u);
    // A bow tie has no vector area, but it does have area.
    quad.quads = {0, 1, 3, 2};
    EXPECT_EQ(scene::count_flat_faces(std::span(&quad, 1)), 0u);
}

}  // namespace
}  // namespace tessera::test
