// Pixar's tag lines.
#include "scene/obj_files.hpp"

namespace tessera::test {
namespace {

TEST(ObjTags, CreasesAndCornersNameVerticesOfTheMesh) {
    // Faces use the corners in another order than the file lists them.
    const auto scene = load_obj_text(cube +
                                     "t crease 2/1/0 0 1 2.5\nt crease 2/1/0 6 5 10\nt corner 1/1/0 7 3\n"
                                     "t interpolateboundary 1/0/0 2\n");
    EXPECT_TRUE(scene.messages.empty()) << scene.messages[0];
    const auto& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.tags.creases.size(), 2u);
    for (const auto& crease : mesh.tags.creases) {
        const glm::vec3 sum = mesh.positions[crease.a] + mesh.positions[crease.b];
        EXPECT_EQ(sum, crease.sharpness == 2.5f ? glm::vec3(0, -2, -2) : glm::vec3(2, 0, 2));
    }
    ASSERT_EQ(mesh.tags.corners.size(), 1u);
    EXPECT_EQ(mesh.positions[mesh.tags.corners[0].vertex], glm::vec3(-1, 1, 1));
    EXPECT_EQ(mesh.tags.corners[0].sharpness, 3.0f);
    EXPECT_EQ(mesh.tags.interpolate_boundary, 2);
}

TEST(ObjTags, OneLineMayHoldSeveral) {
    const auto tags = load_obj_text(cube + "t crease 4/1/0 0 1 1 2 4\nt corner 2/2/0 0 1 5 -6\n").meshes.at(0).tags;
    ASSERT_EQ(tags.creases.size(), 2u);
    EXPECT_EQ(tags.creases[0].sharpness, 4.0f);
    EXPECT_EQ(tags.creases[1].sharpness, 4.0f);
    ASSERT_EQ(tags.corners.size(), 2u);
    EXPECT_EQ(tags.corners[0].sharpness, 5.0f);
    EXPECT_EQ(tags.corners[1].sharpness, 0.0f) << "never below zero";
}

TEST(ObjTags, HolesAreLeftOut) {
    const auto scene = load_obj_text(cube + "t hole 2/0/0 1 5\n");
    const auto& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.quads.size() / 4, 4u);
    EXPECT_EQ(mesh.tags.holes, (std::vector<std::uint32_t>{1, 5}));
    EXPECT_TRUE(has_message(scene, "2 faces are tagged as holes"));
}

TEST(ObjTags, HolesCountAllFaceStatements) {
    const auto scene = load_obj_text(square + "f 1 2\nf 1 2 3\nf 1 3 4\nt hole 1/0/0 1\n");
    EXPECT_EQ(scene.meshes.at(0).positions[1], glm::vec3(1, 1, 0)) << "face 2, from 0, is left";
}

TEST(ObjTags, SplittingMakesTwoOfACrease) {
    const auto scene = load_obj_text(mixed_cube + "t crease 2/1/0 1 2 3\nt corner 1/1/0 2 4\n");
    const auto& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.tags.creases.size(), 2u);
    for (const auto& crease : mesh.tags.creases) {
        EXPECT_EQ(crease.sharpness, 3.0f);
        const glm::vec3 a = mesh.positions[crease.a], b = mesh.positions[crease.b];
        EXPECT_TRUE(a == glm::vec3(1, 0, -1) || b == glm::vec3(1, 0, -1));
        EXPECT_EQ(glm::length(a - b), 1.0f);
    }
    EXPECT_EQ(mesh.positions[mesh.tags.corners.at(0).vertex], glm::vec3(1, 1, -1));
}

TEST(ObjTags, ACreaseBetweenTwoMeshesIsInBoth) {
    std::string text = cube;
    text.insert(text.find("f 5 6 7 8"), "usemtl a\n");
    const auto scene = load_obj_text(text + "t crease 2/1/0 0 1 2\n");
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[0].tags.creases.size(), 1u);
    EXPECT_EQ(scene.meshes[1].tags.creases.size(), 1u);
}

TEST(ObjTags, WhatBelongsToNoFaceIsSaid) {
    const auto scene = load_obj_text(cube + "v 9 9 9\nt crease 2/1/0 0 6 2\nt corner 1/1/0 8 1\n");
    EXPECT_TRUE(scene.meshes.at(0).tags.creases.empty());
    EXPECT_TRUE(scene.meshes[0].tags.corners.empty());
    EXPECT_TRUE(has_message(scene, "1 creases and 1 corner tags are on no face"));
    EXPECT_TRUE(has_message(load_obj_text(cube + "t crease 2/1/0 0 8 2\nt hole 1/0/0 6\n"),
                            "2 tags name vertices or faces that do not exist"));
}

TEST(ObjTags, UnknownAndDamagedOnesAreSaidAndSkipped) {
    EXPECT_TRUE(
        has_message(load_obj_text(cube + "t smoothtriangles 0/0/1 on\n"), "\"smoothtriangles\" are not supported"));
    for (const char* text : {"t crease", "t crease 2/1 0 1 2", "t crease 2/1/0 0 1", "t crease 3/1/0 0 1 2 2",
                             "t crease 2/0/0 0 1", "t crease -2/1/0 0 1 2", "t crease 99999999999/1/0 0 1 2",
                             "t crease 2147483647/2147483647/0 0 1 2", "t corner 1/1/0 -1 2", "t corner 1/1/0 x 2",
                             "t corner 1/1/0 1 nan", "t hole 0/0/0", "t interpolateboundary 0/0/0"}) {
        const auto scene = load_obj_text(cube + text + "\n");
        expect_sound(scene);
        EXPECT_TRUE(has_message(scene, "Line 15: the tag")) << text;
        EXPECT_TRUE(scene.meshes.at(0).tags.creases.empty() && scene.meshes[0].tags.corners.empty()) << text;
    }
}

}  // namespace
}  // namespace tessera::test
