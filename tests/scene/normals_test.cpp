// Normals that a file does not give, or gives badly.
#include "scene/normals.hpp"

#include "scene/gltf_builder.hpp"

#include <cmath>
#include <cstring>

namespace tessera::test {
namespace {

using json = nlohmann::json;

/// A cube of six quads whose corners are all separate vertices; each quad's diagonal is chosen by a bit of `diagonals`.
std::vector<float> cube_soup(unsigned diagonals) {
    std::vector<float> out;
    const auto add = [&](const glm::vec3& p) { out.insert(out.end(), {p.x, p.y, p.z}); };
    for (int face = 0; face < 6; ++face) {
        glm::vec3 n(0.0f), r(0.0f);
        n[face / 2] = face % 2 ? -1.0f : 1.0f;
        r[(face / 2 + 1) % 3] = n[face / 2];
        const glm::vec3 u = glm::cross(n, r);
        const glm::vec3 a = n - r - u, b = n + r - u, c = n + r + u, d = n - r + u;
        if (diagonals >> face & 1) {
            for (const auto& p : {a, b, c, a, c, d})
                add(p);
        } else {
            for (const auto& p : {a, b, d, b, c, d})
                add(p);
        }
    }
    return out;
}

TEST(Normals, AreWeightedByAngleSoThatDiagonalsDoNotMatter) {
    for (const unsigned diagonals : {0u, 0x3fu, 0x15u, 0x0bu}) {
        GltfBuilder builder;
        builder.add_mesh_node({{"attributes", {{"POSITION", builder.add_positions(cube_soup(diagonals))}}}});
        const scene::Mesh mesh = builder.load().meshes.at(0);
        ASSERT_EQ(mesh.positions.size(), 36u);
        for (std::size_t v = 0; v < 36; ++v) {
            EXPECT_LT(glm::length(mesh.normals[v] - glm::normalize(mesh.positions[v])), 1e-6f);
        }
    }
}

TEST(Normals, EqualPositionsGetEqualBitsAcrossPrimitives) {
    GltfBuilder builder;
    const auto soup = cube_soup(0x2a);
    const auto part = [&](std::size_t from, std::size_t to) {
        const std::vector<float> positions(soup.begin() + static_cast<std::ptrdiff_t>(from),
                                           soup.begin() + static_cast<std::ptrdiff_t>(to));
        return json{{"attributes", {{"POSITION", builder.add_positions(positions)}}}};
    };
    const json first = part(0, 54);
    const json second = part(54, 108);
    builder.push("meshes", {{"primitives", {first, second}}});
    builder.push("nodes", {{"mesh", 0}, {"rotation", {0.1, 0.2, 0.3, 0.9}}});
    const scene::Scene scene = builder.load();
    ASSERT_EQ(scene.meshes.size(), 2u);
    int shared = 0;
    for (std::size_t a = 0; a < 18; ++a) {
        for (std::size_t b = 0; b < 18; ++b) {
            if (std::memcmp(&scene.meshes[0].positions[a], &scene.meshes[1].positions[b], sizeof(glm::vec3)) != 0)
                continue;
            EXPECT_EQ(std::memcmp(&scene.meshes[0].normals[a], &scene.meshes[1].normals[b], sizeof(glm::vec3)), 0);
            ++shared;
        }
    }
    EXPECT_GT(shared, 10);
}

TEST(Normals, NodesAreNotWeldedToEachOther) {
    GltfBuilder builder;
    builder.add_mesh_node({{"attributes", {{"POSITION", builder.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}});
    builder.add_mesh_node({{"attributes", {{"POSITION", builder.add_positions({0, 0, 0, 0, 1, 0, 0, 0, 1})}}}});
    const scene::Scene scene = builder.load();
    EXPECT_EQ(scene.meshes.at(0).normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.meshes.at(1).normals[0], glm::vec3(1, 0, 0));
}

TEST(Normals, TrianglesWithoutAreaDoNotCount) {
    GltfBuilder builder;
    // The second triangle has no area, and the last vertex no other one.
    builder.add_mesh_node({{"attributes",
                            {{"POSITION", builder.add_positions({0, 0, 0, 0, 0, 1, 1, 0, 0,  //
                                                                 0, 0, 0, 1, 0, 0, 2, 0, 0})}}}});
    const scene::Scene scene = builder.load();
    expect_sound(scene);
    EXPECT_EQ(scene.meshes.at(0).normals[0], glm::vec3(0, 1, 0));
    EXPECT_EQ(scene.meshes.at(0).normals[3], glm::vec3(0, 1, 0));
    EXPECT_EQ(scene.meshes.at(0).normals[5], glm::vec3(0, 0, 1));
}

TEST(Normals, TinyAndHugeTrianglesHaveThem) {
    for (const float size : {1e-38f, 1e-30f, 1e30f, 1e38f}) {
        GltfBuilder builder;
        builder.add_mesh_node(
            {{"attributes", {{"POSITION", builder.add_positions({0, 0, 0, 0, size, 0, 0, 0, size})}}}});
        const scene::Scene scene = builder.load();
        EXPECT_EQ(scene.meshes.at(0).normals[1], glm::vec3(1, 0, 0)) << size;
    }
}

TEST(Normals, GivenOnesStaySplitAndBadOnesAreRepaired) {
    GltfBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int normals = builder.add_positions({0, 1, 0, 0, 0, 0, 0, 0, 3, 1, 0, 0, 1, 0, 0, NAN, 0, 0});
    builder.add_mesh_node({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
    const scene::Scene scene = builder.load();
    expect_sound(scene);
    const auto& n = scene.meshes.at(0).normals;
    EXPECT_EQ(n[0], glm::vec3(0, 1, 0));
    EXPECT_EQ(n[3], glm::vec3(1, 0, 0));
    EXPECT_EQ(n[1], glm::vec3(0, 0, 1));
    EXPECT_EQ(n[2], glm::vec3(0, 0, 1));
    EXPECT_EQ(n[5], glm::vec3(0, 0, 1));
    EXPECT_TRUE(has_message(scene, "2 normals are zero or not finite"));
    EXPECT_TRUE(has_message(scene, "1 normals are not of unit length"));
}

}  // namespace
}  // namespace tessera::test
