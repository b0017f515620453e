// Tangents in files: .ply as they are, .glb as glTF wants them, .obj not at all.
#include "base/error.hpp"
#include "export/gltf_tangent.hpp"
#include "export/mesh_readers.hpp"
#include "export/sample_mesh.hpp"

#include <gtest/gtest.h>
#include <glm/glm.hpp>

#include <cstring>
#include <limits>

namespace tessera::test {
namespace {

using exporting::GltfTangent;
using glm::dvec3;

dvec3 vector(const float* v) {
    return {v[0], v[1], v[2]};
}

TEST(TangentFiles, PlyKeepsEveryBit) {
    const TemporaryFolder folder;
    const SampleMesh mesh = sample_mesh_with_tangents(12000);  // more than the writer packs at a time
    for (const std::size_t batch : {12000, 7}) {
        write_sample(folder / "mesh.ply", mesh, batch);
        const ReadMesh read = read_mesh(folder / "mesh.ply");
        ASSERT_EQ(read.tangents.size(), mesh.tangents.size());
        EXPECT_EQ(std::memcmp(read.vertices.data(), mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex)), 0);
        EXPECT_EQ(read.parts[0].indices, mesh.indices);
        for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
            const Tangent& t = mesh.tangents[i];
            ASSERT_EQ(read.tangents[i], (std::array{t.tangent[0], t.tangent[1], t.tangent[2], t.handedness}));
            ASSERT_EQ(read.bitangents[i], (std::array{t.bitangent[0], t.bitangent[1], t.bitangent[2]}));
        }
    }
}

TEST(TangentFiles, GlbHasThemAtRightAnglesWithTheNormal) {
    const TemporaryFolder folder;
    const SampleMesh mesh = sample_mesh_with_tangents(12000);
    std::string one_batch;
    for (const std::size_t batch : {12000, 7}) {
        write_sample(folder / "mesh.glb", mesh, batch);
        const ReadMesh read = read_mesh(folder / "mesh.glb");
        ASSERT_EQ(read.tangents.size(), mesh.tangents.size());
        EXPECT_EQ(std::memcmp(read.vertices.data(), mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex)), 0);
        for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
            const dvec3 n = vector(mesh.vertices[i].normal);
            const dvec3 t = vector(read.tangents[i].data());
            const dvec3 given = vector(mesh.tangents[i].tangent);
            ASSERT_NEAR(glm::length(t), 1.0, 1e-6);
            ASSERT_NEAR(glm::dot(t, n), 0.0, 1e-6);
            ASSERT_NEAR(glm::dot(glm::cross(n, t), given), 0.0, 1e-6) << "turned within the plane of both";
            ASSERT_GT(glm::dot(t, given), 0.0);
            ASSERT_EQ(read.tangents[i][3], mesh.tangents[i].handedness);
        }
        const std::string bytes = read_bytes(folder / "mesh.glb");
        EXPECT_TRUE(one_batch.empty() || one_batch == bytes);
        one_batch = bytes;
    }
}

TEST(TangentFiles, GlbWithTangentsKeepsImages) {
    const TemporaryFolder folder;
    SampleMesh mesh = sample_mesh_with_tangents(10);
    mesh.scene.images = {{"fur.jpg", "image/jpeg", std::vector<std::byte>(7, std::byte{0xab}), {}}};
    mesh.scene.materials[1].base_color_image = 0;
    write_sample(folder / "mesh.glb", mesh, 4);
    const GlbFile file = read_glb_file(folder / "mesh.glb");
    const nlohmann::json& view = file.json["bufferViews"][file.json["images"][0]["bufferView"].get<std::size_t>()];
    EXPECT_EQ(std::string(7, '\xab'), file.binary.substr(view["byteOffset"], view["byteLength"]));
}

TEST(TangentFiles, ATangentAlongTheNormalGivesWayToTheBitangent) {
    const Vertex vertex{{0, 0, 0}, {0, 0, 1}, {0, 0}};
    for (const float handedness : {1.0f, -1.0f}) {
        const GltfTangent from_bitangent = exporting::gltf_tangent(vertex, {{0, 0, 1}, handedness, {0.6f, 0, 0.8f}, 0});
        const dvec3 t{from_bitangent.x, from_bitangent.y, from_bitangent.z};
        EXPECT_NEAR(glm::length(t), 1.0, 1e-6);
        const dvec3 bitangent = glm::cross(dvec3{0, 0, 1}, t) * double(from_bitangent.w);
        EXPECT_NEAR(bitangent.x, 1.0, 1e-6) << "as near to the given one as a right angle allows";
        const GltfTangent any = exporting::gltf_tangent(vertex, {{0, 0, 1}, handedness, {0, 0, -1}, 0});
        EXPECT_NEAR(std::hypot(any.x, any.y), 1.0, 1e-6);
        EXPECT_EQ(any.z, 0.0f);
        EXPECT_EQ(any.w, handedness);
    }
}

void expect_error(const SampleMesh& mesh, const char* file, ErrorKind kind, const std::string& part) {
    const TemporaryFolder folder;
    try {
        write_sample(folder / file, mesh, 3);
        ADD_FAILURE() << "was written";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), kind);
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(TangentFiles, ObjRefusesThem) {
    expect_error(sample_mesh_with_tangents(10), "mesh.obj", ErrorKind::usage, "no place for tangents");
}

TEST(TangentFiles, UnsoundOnesAreRefused) {
    for (const char* file : {"mesh.glb", "mesh.ply"}) {
        SampleMesh mesh = sample_mesh_with_tangents(10);
        mesh.tangents[17].bitangent[1] = std::numeric_limits<float>::quiet_NaN();
        expect_error(mesh, file, ErrorKind::output, "vertex 17");
        mesh = sample_mesh_with_tangents(10);
        mesh.tangents[5].handedness = 0.0f;
        expect_error(mesh, file, ErrorKind::output, "vertex 5");
        const TemporaryFolder folder;
        mesh = sample_mesh_with_tangents(10);
        mesh.tangents.clear();
        EXPECT_THROW(write_sample(folder / file, mesh, 3), std::logic_error) << "announced, not brought";
    }
}

}  // namespace
}  // namespace tessera::test
