// What OBJ statements mean: faces, indices, groups, texture coordinates, and what is left out.
#include "scene/obj_files.hpp"

#include <cmath>

namespace tessera::test {
namespace {

using Indices = std::vector<std::uint32_t>;

TEST(Obj, QuadsStayQuadsAndTrianglesTriangles) {
    const auto scene = load_obj_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 1 2 3 4\nf 2 5 3\n");
    expect_sound(scene);
    ASSERT_EQ(scene.meshes.size(), 1u);
    const auto& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.quads, (Indices{0, 1, 2, 3}));
    EXPECT_EQ(mesh.triangles, (Indices{1, 4, 2}));
    EXPECT_EQ(mesh.positions[4], glm::vec3(2, 0, 0));
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_TRUE(scene.messages.empty()) << scene.messages[0];
    EXPECT_EQ(scene.materials.size(), 1u);
}

TEST(Obj, RelativeIndicesCountBackFromWhereTheyStand) {
    const auto scene = load_obj_text("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 5\nf -4 -3 -1\n");
    const auto& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.triangles, (Indices{0, 1, 2, 0, 1, 3}));
    EXPECT_EQ(mesh.positions[2], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.positions[3], glm::vec3(0, 0, 5));
    EXPECT_TRUE(has_message(scene, "1 positions are used by no face"));
}

TEST(Obj, VerticesMayFollowTheFacesThatUseThem) {
    EXPECT_EQ(load_obj_text("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").meshes.at(0).triangles.size(), 3u);
}

TEST(Obj, TextureCoordinatesAreTurnedRound) {
    const auto scene = load_obj_text(square + "vt 0.25 0.125\nvt 1 0\nvt 1 1\nvt 0.5\nf 1/1 2/2 3/3 4/4\n");
    const auto& uvs = scene.meshes.at(0).uvs;
    EXPECT_EQ(uvs[0], glm::vec2(0.25f, 0.875f));
    EXPECT_EQ(uvs[2], glm::vec2(1.0f, 0.0f));
    EXPECT_EQ(uvs[3], glm::vec2(0.5f, 1.0f)) << "v may be left away and is 0 then";
}

TEST(Obj, ASlashWithNothingBehindItNamesNothing) {
    const auto scene = load_obj_text(square + "vt 0.5 0.5\nf 1/ 2// 3/1/ 4/1\n");
    EXPECT_EQ(scene.meshes.at(0).quads.size(), 4u);
    EXPECT_EQ(scene.meshes[0].uvs[1], glm::vec2(0.0f));
    EXPECT_EQ(scene.meshes[0].uvs[2], glm::vec2(0.5f));
}

TEST(Obj, CornersWithDifferentTextureCoordinatesAreSeparateVertices) {
    const auto scene = load_obj_text(square + "vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 3/1 4/1\n");
    const auto& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.positions.size(), 5u);
    EXPECT_EQ(mesh.triangles, (Indices{0, 1, 2, 3, 2, 4}));
    EXPECT_EQ(mesh.positions[0], mesh.positions[3]);
}

TEST(Obj, ThereIsAMeshForEachObjectGroupAndMaterial) {
    const auto scene = load_obj_text(square +
                                     "o first\nusemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\nusemtl a\nf 2 3 4\n"
                                     "g left side\nf 1 2 4\no second\nf 1 2 3\nf 3 4 1\n");
    ASSERT_EQ(scene.meshes.size(), 4u);
    EXPECT_EQ(scene.meshes[0].name, "first");
    EXPECT_EQ(scene.meshes[0].triangles.size(), 6u) << "back to material a";
    EXPECT_EQ(scene.meshes[1].name, "first");
    EXPECT_EQ(scene.meshes[2].name, "first/left side");
    EXPECT_EQ(scene.meshes[3].name, "second") << "a new object is in no group";
    EXPECT_EQ(scene.materials[scene.meshes[0].material].name, "a");
    EXPECT_EQ(scene.materials[scene.meshes[1].material].name, "b");
    EXPECT_EQ(scene.meshes[0].material, scene.meshes[3].material);
    EXPECT_TRUE(has_message(scene, "\"b\" is not defined"));
}

TEST(Obj, CommentsBlankLinesAndAnyLineEndsAreRead) {
    const auto expected = load_obj_text(square + "f 1 2 3 4\n").meshes.at(0);
    for (const std::string& text :
         {"\xef\xbb\xbf" + square + "f 1 2 3 4", "# f 1\n\n  \t\n" + square + "\tf  1\t2 3 4   # four\n",
          square + "f 1 2 \\\n3 \\\r\n4\n", std::string("v 0 0 0\rv 1 0 0\rv 1 1 0\r\nv +0 1e0 .0 1.0\rf 1 2 3 4\r")}) {
        const auto scene = load_obj_text(text);
        ASSERT_EQ(scene.meshes.size(), 1u) << text;
        EXPECT_EQ(scene.meshes[0].positions, expected.positions) << text;
        EXPECT_EQ(scene.meshes[0].quads, expected.quads) << text;
    }
}

TEST(Obj, NegativeZerosBecomePositive) {
    expect_sound(load_obj_text("v -0 -0.0 -0e5\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
}

TEST(Obj, DegenerateFacesAreCountedAndTheRestStays) {
    const auto scene = load_obj_text(square +
                                     "f 1 1 3\nf 1 2 1 3\nf 1 2 2 3\nf 1 2\nf 3\nf\nf 1 2 3 4\n"
                                     "f 1 2 3 4 3\n");
    expect_sound(scene);
    const auto& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.triangles, (Indices{0, 1, 2, 0, 1, 2})) << "1 2 2 3, and 1 2 3 4 3 without its spike";
    EXPECT_EQ(mesh.quads.size(), 4u);
    EXPECT_TRUE(has_message(scene, "3 faces of fewer than three corners"));
    EXPECT_TRUE(has_message(scene, "2 faces repeat a corner"));
    EXPECT_TRUE(has_message(scene, "2 faces have fewer than three different corners"));
}

TEST(Obj, NonManifoldEdgesStayAndAreCounted) {
    const auto scene = load_obj_text(square + "v 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
    EXPECT_EQ(scene.meshes.at(0).triangles.size(), 9u);
    EXPECT_TRUE(has_message(scene, "1 edges are used by more than two faces"));
}

TEST(Obj, CoordinatesThatAreNotFiniteTakeOnlyTheirFacesWithThem) {
    for (const char* bad : {"nan", "-inf", "1e39", "1.#IND", "0e999", "x", "1e", "0x10", "1,5"}) {
        const auto scene = load_obj_text(square + "v 0 " + bad + " 0\nf 1 2 3\nf 1 2 5\nf 3 4 5 1\n");
        expect_sound(scene);
        EXPECT_TRUE(scene.meshes.at(0).quads.empty()) << bad;
        // A zero with a huge exponent is a number; only if the reader makes something else of it is the face dropped.
        if (std::string(bad) == "0e999") continue;
        EXPECT_EQ(scene.meshes[0].triangles.size(), 3u) << bad;
        EXPECT_TRUE(has_message(scene, "1 positions are not finite numbers; they are left out with the 2 faces"))
            << bad;
    }
}

TEST(Obj, TextureCoordinatesThatAreNotFiniteBecomeZero) {
    const auto scene = load_obj_text(square + "vt nan inf\nf 1/1 2/1 3/1\n");
    expect_sound(scene);
    EXPECT_TRUE(has_message(scene, "1 texture coordinates are not finite"));
}

TEST(Obj, WhatIsNotASurfaceIsNamed) {
    const auto scene = load_obj_text(square + "v 0 0 0 1 0.5 0\nl 1 2\np 1\ncurv 0 1 1 2\nf 1 2 3\n");
    EXPECT_TRUE(has_message(scene, "2 statements of lines or points"));
    EXPECT_TRUE(has_message(scene, "\"curv\" are not supported"));
    EXPECT_TRUE(has_message(scene, "colours"));
}

TEST(Obj, AFileWithoutFacesIsASceneWithoutMeshes) {
    const auto scene = load_obj_text(square);
    EXPECT_TRUE(scene.meshes.empty());
    EXPECT_EQ(scene.materials.size(), 1u);
    EXPECT_TRUE(has_message(scene, "no faces"));
}

}  // namespace
}  // namespace tessera::test
