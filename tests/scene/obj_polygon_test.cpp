// Faces of more than four corners: split into quads with all their neighbours, or cut into triangles.
#include "scene/obj_files.hpp"

#include <fmt/format.h>
#include <rapidcheck/gtest.h>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace tessera::test {
namespace {

using scene::NgonMode;

/// Area of every triangle or quad of a mesh in the plane z = 0, positive where it faces +z.
std::vector<double> areas(const scene::Mesh& mesh) {
    std::vector<double> out;
    const auto add = [&](const std::vector<std::uint32_t>& faces, std::size_t n) {
        for (std::size_t i = 0; i < faces.size(); i += n) {
            double sum = 0.0;
            for (std::size_t k = 0; k < n; ++k) {
                const glm::dvec3 a(mesh.positions[faces[i + k]]), b(mesh.positions[faces[i + (k + 1) % n]]);
                sum += 0.5 * (a.x * b.y - a.y * b.x);
            }
            out.push_back(sum);
        }
    };
    add(mesh.triangles, 3);
    add(mesh.quads, 4);
    return out;
}

/// Expects pieces that all face +z and make up the whole area.
void expect_covers(const scene::Scene& scene, double area) {
    expect_sound(scene);
    const auto pieces = areas(scene.meshes.at(0));
    for (const double piece : pieces)
        ASSERT_GT(piece, 0.0);
    EXPECT_NEAR(std::accumulate(pieces.begin(), pieces.end(), 0.0), area, 1e-5 * area);
}

/// A face whose corners are given around.
std::string face_of(const std::vector<glm::dvec2>& corners) {
    std::string text, face = "f";
    for (std::size_t i = 0; i < corners.size(); ++i) {
        text += fmt::format("v {} {} 0\n", corners[i].x, corners[i].y);
        face.append(" ").append(std::to_string(i + 1));
    }
    return text + face + "\n";
}

TEST(ObjSplit, APentagonBecomesFiveQuadsAroundItsMean) {
    const auto scene = load_obj_text("v 0 0 0\nv 2 0 0\nv 3 1 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n");
    const auto& mesh = scene.meshes.at(0);
    EXPECT_TRUE(mesh.triangles.empty());
    ASSERT_EQ(mesh.quads.size(), 20u);
    const auto corner = [&](std::size_t i) { return mesh.positions[mesh.quads[i]]; };
    EXPECT_EQ(corner(0), glm::vec3(0, 0, 0));
    EXPECT_EQ(corner(1), glm::vec3(1, 0, 0)) << "the middle of the next edge";
    EXPECT_EQ(corner(2), glm::vec3(1.4f, 1, 0)) << "the mean of the corners";
    EXPECT_EQ(corner(3), glm::vec3(0, 1, 0)) << "the middle of the edge before";
    expect_covers(scene, 5.0);
    EXPECT_TRUE(has_message(scene, "1 faces have more than four corners"));
}

TEST(ObjSplit, AllFacesOfTheFileAreSplitSoThatItStaysClosed) {
    const auto scene = load_obj_text(mixed_cube);
    expect_sound(scene);
    EXPECT_EQ(scene.meshes.at(0).quads.size() / 4, 2u * 3 + 2 * 5 + 3 * 4);
    expect_closed(scene.meshes[0]);
}

TEST(ObjSplit, NeighboursOfAnotherMaterialAreSplitToo) {
    std::string text = mixed_cube;
    text.insert(text.find("f 2 3 7 6"), "usemtl other\n");
    const auto scene = load_obj_text(text);
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_TRUE(scene.meshes[1].triangles.empty());
    EXPECT_EQ(scene.meshes[1].quads.size() / 4, 12u);
    expect_closed(scene.meshes);
}

TEST(ObjSplit, WithoutLargerFacesNothingIsSplit) {
    const auto scene = load_obj_text(cube);
    EXPECT_EQ(scene.meshes.at(0).quads.size() / 4, 6u);
    expect_closed(scene.meshes[0]);
}

TEST(ObjSplit, TextureCoordinatesAndNormalsAreHalvedToo) {
    const auto scene = load_obj_text(
        "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 2 2 0\nv 0 2 0\nvt 0 1\nvt 1 1\nvt 1 0\nvn 0 0 1\nvn 1 0 0\n"
        "f 1/1/1 2/2/2 3/3/1 4/3/1 5/3/1\n");
    const auto& mesh = scene.meshes.at(0);
    const std::uint32_t middle = mesh.quads.at(1);
    EXPECT_EQ(mesh.uvs[middle], glm::vec2(0.5f, 0.0f));
    EXPECT_NEAR(mesh.normals[middle].x, std::sqrt(0.5f), 1e-6f);
    EXPECT_NEAR(mesh.normals[middle].z, std::sqrt(0.5f), 1e-6f);
}

TEST(ObjSplit, OppositeNormalsLeaveTheirMiddleToTheFaces) {
    const auto scene =
        load_obj_text("v 0 0 0\nv 2 0 0\nv 3 1 0\nv 2 2 0\nv 0 2 0\nvn 1 0 0\nvn -1 0 0\nf 1//1 2//2 3//1 4//1 5//1\n");
    expect_sound(scene);
    EXPECT_EQ(scene.meshes.at(0).normals[scene.meshes[0].quads.at(1)], glm::vec3(0, 0, 1));
}

TEST(ObjSplit, AFaceTooConcaveIsCutBeforeItIsSplit) {
    const std::vector<glm::dvec2> letter_c{{0, 0}, {9, 0}, {9, 1}, {1, 1}, {1, 8}, {9, 8}, {9, 9}, {0, 9}};
    const auto scene = load_obj_text(face_of(letter_c));
    expect_covers(scene, 25.0);
    EXPECT_TRUE(scene.meshes.at(0).triangles.empty());
    EXPECT_EQ(scene.meshes[0].quads.size() / 4, 6u * 3);
    EXPECT_TRUE(has_message(scene, "too concave"));
}

TEST(ObjFan, OtherFacesStay) {
    const auto scene = load_obj_text(mixed_cube, NgonMode::fan);
    expect_sound(scene);
    EXPECT_EQ(scene.meshes.at(0).triangles.size() / 3, 2u + 3 + 3);
    EXPECT_EQ(scene.meshes[0].quads.size() / 4, 3u);
    expect_closed(scene.meshes[0]);
}

TEST(ObjFan, ConcaveFacesAreCutInside) {
    const std::vector<glm::dvec2> letter_c{{0, 0}, {9, 0}, {9, 1}, {1, 1}, {1, 8}, {9, 8}, {9, 9}, {0, 9}};
    const auto scene = load_obj_text(face_of(letter_c), NgonMode::fan);
    expect_covers(scene, 25.0);
    EXPECT_EQ(scene.meshes.at(0).triangles.size() / 3, 6u);
}

TEST(ObjFan, ABridgeToAHoleIsCutRight) {
    // A square with a square hole; the bridge runs from corner 1 to corner 5 of the hole and back.
    const std::string ring =
        "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\nf 1 2 3 4 1 5 6 7 8 5\n";
    expect_covers(load_obj_text(ring, NgonMode::fan), 8.0);
    expect_covers(load_obj_text(ring, NgonMode::split), 8.0);
}

TEST(ObjFan, CornersOnAStraightEdgeAreKept) {
    const auto scene =
        load_obj_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nf 1 2 3 4 5 6\n", NgonMode::fan);
    EXPECT_EQ(scene.meshes.at(0).positions.size(), 6u);
    EXPECT_EQ(scene.meshes[0].triangles.size() / 3, 4u);
    expect_covers(scene, 9.0);
}

TEST(ObjFan, FacesWithoutAnyAreaAreCutSomehow) {
    for (const NgonMode mode : {NgonMode::fan, NgonMode::split}) {
        expect_sound(load_obj_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 4 0 0\nf 1 2 3 4 5\n", mode));
        expect_sound(load_obj_text("v 1 1 1\nv 1 1 1\nv 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3 4 5\n", mode));
        expect_sound(load_obj_text("v 0 0 0\nv 4 4 0\nv 4 0 0\nv 0 4 0\nv 2 9 0\nf 1 2 3 4 5\n", mode));
    }
}

/// A polygon around the origin with corners at rising angles and random distances: concave, but never crossing itself.
RC_GTEST_PROP(ObjFan, RandomConcavePolygonsAreCovered, ()) {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto n = *rc::gen::inRange<std::size_t>(5, 40);
    std::uniform_real_distribution<double> distance(0.2, 5.0);
    std::vector<glm::dvec2> corners;
    double area = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        corners.push_back(glm::dvec2(std::cos(angle), std::sin(angle)) * distance(random) + 7.0);
    }
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 a = corners[i] - 7.0, b = corners[(i + 1) % n] - 7.0;
        area += 0.5 * (a.x * b.y - a.y * b.x);
    }
    const auto scene = load_obj_text(face_of(corners), NgonMode::fan);
    RC_ASSERT(scene.meshes.at(0).triangles.size() == 3 * (n - 2));
    const auto pieces = areas(scene.meshes[0]);
    for (const double piece : pieces)
        RC_ASSERT(piece > -1e-5);
    RC_ASSERT(std::abs(std::accumulate(pieces.begin(), pieces.end(), 0.0) - area) < 1e-4 * area);
    const auto split = areas(load_obj_text(face_of(corners)).meshes.at(0));
    for (const double piece : split)
        RC_ASSERT(piece > -1e-5);
    RC_ASSERT(std::abs(std::accumulate(split.begin(), split.end(), 0.0) - area) < 1e-4 * area);
}

}  // namespace
}  // namespace tessera::test
