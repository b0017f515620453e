// Normals of OBJ files: given ones, and smoothing groups where there are none.
#include "scene/obj_files.hpp"

#include <cmath>
#include <map>
#include <set>

namespace tessera::test {
namespace {

/// The different normals that the vertices at a position have.
std::set<std::array<float, 3>> normals_at(const scene::Scene& scene, const glm::vec3& position) {
    std::set<std::array<float, 3>> out;
    for (const auto& mesh : scene.meshes) {
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            if (mesh.positions[v] == position) out.insert({mesh.normals[v].x, mesh.normals[v].y, mesh.normals[v].z});
        }
    }
    return out;
}

std::string with_faces(const std::string& smoothing_first_half, const std::string& smoothing_second_half) {
    const std::size_t faces = cube.find("f ");
    const std::size_t half = cube.find("f 2 3 7 6");
    return cube.substr(0, faces) + smoothing_first_half + cube.substr(faces, half - faces) + smoothing_second_half +
           cube.substr(half);
}

TEST(ObjNormals, GivenOnesAreKeptAndMadeUnit) {
    const auto scene = load_obj_text(square + "vn 0 3 4\nvn 1 0 0\ns 1\nf 1//1 2//1 3//2 4//1\n");
    const auto& mesh = scene.meshes.at(0);
    EXPECT_NEAR(mesh.normals[0].y, 0.6f, 1e-7f);
    EXPECT_NEAR(mesh.normals[0].z, 0.8f, 1e-7f);
    EXPECT_EQ(mesh.normals[2], glm::vec3(1, 0, 0));
}

TEST(ObjNormals, WithoutSmoothingStatementsFacesAreSmooth) {
    const auto scene = load_obj_text(cube);
    EXPECT_EQ(scene.meshes.at(0).positions.size(), 8u);
    const glm::vec3 n = scene.meshes[0].normals[0];
    EXPECT_NEAR(std::abs(n.x), std::sqrt(1.0f / 3.0f), 1e-6f);
    EXPECT_EQ(std::abs(n.x), std::abs(n.y)) << "the quads weigh the same in all directions";
    EXPECT_EQ(std::abs(n.x), std::abs(n.z));
}

TEST(ObjNormals, GroupZeroIsFlat) {
    for (const char* off : {"s off\n", "s 0\n"}) {
        const auto scene = load_obj_text(with_faces(off, ""));
        expect_sound(scene);
        EXPECT_EQ(scene.meshes.at(0).positions.size(), 24u);
        const std::set<std::array<float, 3>> expected{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        EXPECT_EQ(normals_at(scene, {1, 1, 1}), expected);
    }
}

TEST(ObjNormals, DifferentGroupsAreNotSmoothedAcross) {
    // Faces -z, +z, -y in one group; +x, +y, -x in another.
    const auto two = load_obj_text(with_faces("s 1\n", "s 2\n"));
    EXPECT_EQ(two.meshes.at(0).positions.size(), 16u);
    const auto normals = normals_at(two, {1, 1, 1});
    ASSERT_EQ(normals.size(), 2u);
    EXPECT_EQ(normals.count({0, 0, 1}), 1u) << "of its group, only +z is there";
    const auto one = load_obj_text(with_faces("s 1\n", "s 1\n"));
    EXPECT_EQ(one.meshes.at(0).positions.size(), 8u);
}

TEST(ObjNormals, AGroupIsSmoothAcrossMaterialsAndObjects) {
    std::string text = with_faces("s 7\n", "o other\nusemtl m\n");
    const auto scene = load_obj_text(text);
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(normals_at(scene, {1, 1, 1}).size(), 1u) << "and to the bit";
}

TEST(ObjNormals, SmoothingWeldsOnPositionsNotOnIndices) {
    // Two triangles at a right angle, each with positions of its own.
    const auto scene = load_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 0 1 0\nv 0 0 1\ns 1\nf 1 2 3\nf 4 5 6\n");
    EXPECT_EQ(normals_at(scene, {0, 0, 0}).size(), 1u);
    EXPECT_EQ(normals_at(scene, {1, 0, 0}).size(), 1u);
}

TEST(ObjNormals, AFlatPolygonKeepsOneNormalInEitherMode) {
    // Not plane: its triangles would all look elsewhere.
    const std::string text = "v 0 0 0\nv 2 0 0.5\nv 3 1 0\nv 2 2 0.5\nv 0 2 0\ns off\nf 1 2 3 4 5\n";
    for (const auto mode : {scene::NgonMode::split, scene::NgonMode::fan}) {
        const auto scene = load_obj_text(text, mode);
        const auto& mesh = scene.meshes.at(0);
        for (const glm::vec3& normal : mesh.normals)
            EXPECT_LT(glm::length(normal - mesh.normals[0]), 1e-6f);
    }
}

TEST(ObjNormals, UnusableOnesAreComputed) {
    const auto scene = load_obj_text(square + "vn 0 0 0\nvn nan 0 1\nf 1//1 2//2 3//1 4//2\n");
    expect_sound(scene);
    EXPECT_EQ(scene.meshes.at(0).normals[1], glm::vec3(0, 0, 1));
    EXPECT_TRUE(has_message(scene, "4 corners have a normal that is zero or not finite"));
}

TEST(ObjNormals, SomeCornersMayLackThem) {
    const auto scene = load_obj_text(square + "vn 1 0 0\nf 1//1 2 3 4\n");
    EXPECT_EQ(scene.meshes.at(0).normals[0], glm::vec3(1, 0, 0));
    EXPECT_EQ(scene.meshes[0].normals[1], glm::vec3(0, 0, 1));
}

TEST(ObjNormals, AnUnknownSmoothingGroupIsSaid) {
    EXPECT_TRUE(has_message(load_obj_text(square + "s left\nf 1 2 3\n"), "Line 5: the smoothing group \"left\""));
}

}  // namespace
}  // namespace tessera::test
