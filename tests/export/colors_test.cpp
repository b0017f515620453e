// Colours of vertices in files: .glb and .ply as they are, alone and beside tangents; .obj without.
#include "base/error.hpp"
#include "export/mesh_readers.hpp"
#include "export/sample_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <stdexcept>

namespace tessera::test {
namespace {

TEST(ColourFiles, KeepEveryBit) {
    const TemporaryFolder folder;
    for (const bool tangents : {false, true}) {
        SampleMesh mesh = tangents ? sample_mesh_with_tangents(12000) : sample_mesh(12000);  // more than one piece
        paint(mesh);
        for (const char* file : {"mesh.glb", "mesh.ply"}) {
            for (const std::size_t batch : {12000, 7}) {
                SCOPED_TRACE(std::string(file) + (tangents ? " with tangents" : ""));
                write_sample(folder / file, mesh, batch);
                const ReadMesh read = read_mesh(folder / file);
                EXPECT_EQ(
                    std::memcmp(read.vertices.data(), mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex)), 0);
                EXPECT_EQ(read.tangents.size(), mesh.tangents.size());
                ASSERT_EQ(read.colors.size(), mesh.vertices.size());
                for (std::size_t i = 0; i < mesh.attributes.size(); ++i)
                    ASSERT_EQ(std::memcmp(&read.colors[i], mesh.attributes[i].color, 16), 0) << i;
            }
        }
    }
}

TEST(ColourFiles, HaveNoneWhereAttributesAreTangentsAlone) {
    const TemporaryFolder folder;
    SampleMesh mesh = sample_mesh(30);
    paint(mesh);
    mesh.totals.has_colors = false;
    for (const char* file : {"mesh.glb", "mesh.ply"}) {
        write_sample(folder / file, mesh, 7);
        EXPECT_TRUE(read_mesh(folder / file).colors.empty());
    }
}

TEST(ColourFiles, GlbWithColoursKeepsImages) {
    const TemporaryFolder folder;
    SampleMesh mesh = sample_mesh_with_tangents(10);
    paint(mesh);
    mesh.scene.images = {{"fur.jpg", "image/jpeg", std::vector<std::byte>(7, std::byte{0xab}), {}}};
    mesh.scene.materials[1].base_color_image = 0;
    write_sample(folder / "mesh.glb", mesh, 10);
    const GlbFile glb = read_glb_file(folder / "mesh.glb");
    const auto& view = glb.json["bufferViews"][glb.json["images"][0]["bufferView"].get<std::size_t>()];
    EXPECT_EQ(glb.binary.substr(view["byteOffset"].get<std::size_t>(), 7), std::string(7, '\xab'));
}

TEST(ColourFiles, ObjIsWrittenWithout) {
    const TemporaryFolder folder;
    SampleMesh mesh = sample_mesh(10);
    paint(mesh);
    write_sample(folder / "mesh.obj", mesh, 3);
    EXPECT_EQ(read_mesh(folder / "mesh.obj").vertices.size(), mesh.vertices.size());
}

TEST(ColourFiles, AreHeldAgainstTheTotals) {
    const TemporaryFolder folder;
    SampleMesh mesh = sample_mesh(10);
    paint(mesh);
    mesh.attributes[11].color[2] = NAN;
    EXPECT_THROW(write_sample(folder / "mesh.glb", mesh, 10), Error);
    mesh.attributes.clear();
    EXPECT_THROW(write_sample(folder / "mesh.glb", mesh, 10), std::logic_error);
}

}  // namespace
}  // namespace tessera::test
