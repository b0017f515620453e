// Parts, materials and texture coordinates of an .obj.
#include "base/error.hpp"
#include "export/mesh_readers.hpp"
#include "export/sample_mesh.hpp"

#include <gtest/gtest.h>

namespace tessera::test {
namespace {

TEST(Obj, NamesPartsAndMaterials) {
    const TemporaryFolder folder;
    write_sample(folder / "two words.obj", sample_mesh(30), 7);
    const ReadMesh mesh = read_obj(folder / "two words.obj");
    ASSERT_EQ(2u, mesh.parts.size());
    EXPECT_EQ("body", mesh.parts[0].name);
    EXPECT_EQ("fur", mesh.parts[0].material);
    EXPECT_EQ(60u, mesh.parts[0].indices.size());
    EXPECT_EQ("eyes_and_ears", mesh.parts[1].name);
    EXPECT_EQ("material_2", mesh.parts[1].material);
    EXPECT_NE(std::string::npos, read_bytes(folder / "two words.obj").find("mtllib two words.mtl\n"));
    const std::string library = read_bytes(folder / "two words.mtl");
    EXPECT_NE(std::string::npos, library.find("newmtl fur\nKd 0.8 0.4 0.1\nd 1\n")) << library;
    EXPECT_NE(std::string::npos, library.find("newmtl material_2\nKd 0.1 0.2 0.3\nd 0.5\n")) << library;
}

TEST(Obj, EqualMaterialNamesAreKeptApart) {
    const TemporaryFolder folder;
    SampleMesh mesh = sample_mesh(30);
    mesh.scene.materials[0].name = "fur_2";
    mesh.scene.materials[2].name = "fur";
    write_sample(folder / "mesh.obj", mesh, 7);
    const ReadMesh read = read_obj(folder / "mesh.obj");
    EXPECT_EQ("fur", read.parts[0].material);
    EXPECT_EQ("fur_2_2", read.parts[1].material);
}

TEST(Obj, TextureOriginIsLowerLeft) {
    const TemporaryFolder folder;
    SampleMesh mesh = sample_mesh(3);
    mesh.vertices[0].uv[0] = 0.25f;
    mesh.vertices[0].uv[1] = 0.75f;
    write_sample(folder / "mesh.obj", mesh, 7);
    EXPECT_NE(std::string::npos, read_bytes(folder / "mesh.obj").find("vt 0.25 0.25\n"));
}

TEST(Obj, RefusesANameThatMtllibCannotHold) {
    const TemporaryFolder folder;
    EXPECT_THROW(write_sample(folder / "two\nlines.obj", sample_mesh(3), 1), Error);
    EXPECT_EQ(0u, folder.entries());
}

}  // namespace
}  // namespace tessera::test
