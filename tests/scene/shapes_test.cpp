// The built-in shapes are what shapes.hpp says.
#include "scene/shapes.hpp"

#include "scene/gltf_builder.hpp"

#include <cmath>
#include <cstring>
#include <map>

namespace tessera::test {
namespace {

struct Expected {
    const char* name;
    std::size_t triangles;
    double volume;
};

void PrintTo(const Expected& expected, std::ostream* out) {
    *out << expected.name;
}

class Shapes : public testing::TestWithParam<Expected> {};

TEST_P(Shapes, AreClosedOutwardAndSound) {
    const scene::Scene scene = scene::load_scene(GetParam().name);
    expect_sound(scene);
    ASSERT_EQ(scene.meshes.size(), 1u);
    const scene::Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.triangles.size() / 3, GetParam().triangles);
    expect_closed(mesh);
    EXPECT_NEAR(volume(mesh), GetParam().volume, 0.01);
    EXPECT_TRUE(scene.messages.empty());
}

TEST_P(Shapes, HaveNormalsOnTheFrontAndEqualBitsAtSeams) {
    const scene::Mesh mesh = scene::load_scene(GetParam().name).meshes.at(0);
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const auto p = [&](std::size_t k) { return mesh.positions[mesh.triangles[i + k]]; };
        const glm::vec3 face = glm::cross(p(1) - p(0), p(2) - p(0));
        for (std::size_t k = 0; k < 3; ++k)
            ASSERT_GT(glm::dot(face, mesh.normals[mesh.triangles[i + k]]), 0.0f);
    }
    std::map<std::string, std::string> normal_at;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const std::string position(reinterpret_cast<const char*>(&mesh.positions[v]), sizeof(glm::vec3));
        const std::string normal(reinterpret_cast<const char*>(&mesh.normals[v]), sizeof(glm::vec3));
        ASSERT_EQ(normal_at.emplace(position, normal).first->second, normal);
    }
}

TEST_P(Shapes, HaveTextureCoordinatesThatTurnOneWayAndStayInside) {
    const scene::Mesh mesh = scene::load_scene(GetParam().name).meshes.at(0);
    for (const glm::vec2& uv : mesh.uvs) {
        ASSERT_TRUE(uv.x >= 0.0f && uv.x <= 1.0f && uv.y >= 0.0f && uv.y <= 1.0f) << uv.x << " " << uv.y;
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const auto uv = [&](std::size_t k) { return mesh.uvs[mesh.triangles[i + k]]; };
        const glm::vec2 a = uv(1) - uv(0), b = uv(2) - uv(0);
        // v points down, so a picture that is not mirrored turns the other way in (u, v).
        ASSERT_LT(a.x * b.y - a.y * b.x, 0.0f) << "triangle " << i / 3;
    }
}

INSTANTIATE_TEST_SUITE_P(All, Shapes,
                         testing::Values(Expected{"shape:icosahedron", 20, 2.536}, Expected{"shape:cube", 12, 8.0},
                                         Expected{"shape:torus", 192, 2.716}, Expected{"shape:sphere:1", 8, 4.0 / 3.0},
                                         Expected{"shape:sphere:7", 392, 4.062},
                                         Expected{"shape:sphere:64", 32768, 4.187}),
                         [](const auto& info) {
                             std::string name = info.param.name + 6;
                             for (char& c : name)
                                 c = c == ':' ? '_' : c;
                             return name;
                         });

TEST(ShapeNames, TheLargestSphereIsMade) {
    EXPECT_EQ(scene::load_scene("shape:sphere:256").meshes.at(0).triangles.size() / 3, 8u * 256 * 256);
}

TEST(ShapeNames, OthersAreRefusedWithAList) {
    for (const char* name : {"shape:", "shape:teapot", "shape:Cube", "shape:sphere"}) {
        const std::string sentence = refusal(name);
        for (const char* known : {"shape:icosahedron", "shape:cube", "shape:torus", "shape:sphere:N"}) {
            EXPECT_NE(sentence.find(known), std::string::npos) << sentence;
        }
    }
    for (const char* name : {"shape:sphere:", "shape:sphere:0", "shape:sphere:257", "shape:sphere:-1",
                             "shape:sphere:4x", "shape:sphere:99999999999999999999", "shape:sphere:1.5"}) {
        EXPECT_NE(refusal(name).find("from 1 to 256"), std::string::npos);
    }
}

}  // namespace
}  // namespace tessera::test
