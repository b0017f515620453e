// The description in a .glb: materials, images, boxes, names.
#include "base/error.hpp"
#include "export/mesh_readers.hpp"
#include "export/sample_mesh.hpp"

#include <gtest/gtest.h>

namespace tessera::test {
namespace {

using nlohmann::json;

SampleMesh textured_sample() {
    SampleMesh mesh = sample_mesh(10);
    const auto image = [](const char* name, const char* type, std::size_t bytes) {
        return scene::SceneImage{name, type, std::vector<std::byte>(bytes, std::byte{0xab}), {}};
    };
    mesh.scene.images = {image("unused", "image/png", 5), image("fur.jpg", "image/jpeg", 7),
                         image("eyes.png", "image/png", 9)};
    mesh.scene.materials[1].base_color_image = 1;
    mesh.scene.materials[2].base_color_image = 2;
    return mesh;
}

TEST(Glb, DescribesMaterials) {
    const TemporaryFolder folder;
    SampleMesh mesh = sample_mesh(10);
    mesh.scene.materials[1].alpha_mode = scene::AlphaMode::mask;
    mesh.scene.materials[1].alpha_cutoff = 0.25f;
    mesh.scene.materials[2].double_sided = true;
    mesh.scene.materials[2].base_color = {7.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(), 0.5f};
    write_sample(folder / "mesh.glb", mesh, 4);
    const json file = read_glb_file(folder / "mesh.glb").json;
    ASSERT_EQ(2u, file["materials"].size()) << "the material of the part without triangles is left out";
    const json& fur = file["materials"][0];
    EXPECT_EQ("fur", fur["name"]);
    EXPECT_EQ("MASK", fur["alphaMode"]);
    EXPECT_EQ(0.25f, fur["alphaCutoff"]);
    EXPECT_FALSE(fur.contains("doubleSided"));
    EXPECT_EQ(json({0.8f, 0.4f, 0.1f, 1.0f}), fur["pbrMetallicRoughness"]["baseColorFactor"]);
    const json& eyes = file["materials"][1];
    EXPECT_EQ("BLEND", eyes["alphaMode"]);
    EXPECT_FALSE(eyes.contains("alphaCutoff"));
    EXPECT_EQ(true, eyes["doubleSided"]);
    EXPECT_EQ(json({1.0f, 0.0f, 0.0f, 0.5f}), eyes["pbrMetallicRoughness"]["baseColorFactor"]);
    EXPECT_EQ(1, file["meshes"][0]["primitives"][1]["material"]);
    EXPECT_EQ("2.0", file["asset"]["version"]);
    EXPECT_EQ(0u, file["asset"]["generator"].get<std::string>().find("Tessera "));
}

TEST(Glb, EmbedsImagesAsTheyAre) {
    const TemporaryFolder folder;
    const SampleMesh mesh = textured_sample();
    write_sample(folder / "mesh.glb", mesh, 4);
    const GlbFile file = read_glb_file(folder / "mesh.glb");
    ASSERT_EQ(2u, file.json["images"].size());
    for (std::size_t i = 0; i < 2; ++i) {
        const json& texture = file.json["materials"][i]["pbrMetallicRoughness"]["baseColorTexture"];
        const json& image =
            file.json["images"][file.json["textures"][texture["index"].get<int>()]["source"].get<int>()];
        const scene::SceneImage& original = mesh.scene.images[i + 1];
        EXPECT_EQ(original.mime_type, image["mimeType"]);
        EXPECT_EQ(original.name, image["name"]);
        const json& view = file.json["bufferViews"][image["bufferView"].get<std::size_t>()];
        EXPECT_EQ(std::string(original.encoded.size(), '\xab'),
                  file.binary.substr(view["byteOffset"], view["byteLength"]));
    }
}

TEST(Glb, BoxesAreThoseOfTheParts) {
    const TemporaryFolder folder;
    const SampleMesh mesh = sample_mesh(30);
    write_sample(folder / "mesh.glb", mesh, 7);
    const json file = read_glb_file(folder / "mesh.glb").json;
    for (std::size_t i = 0; i < 2; ++i) {
        const MeshPart& part = mesh.totals.parts[2 * i];
        const json& accessor =
            file["accessors"][file["meshes"][0]["primitives"][i]["attributes"]["POSITION"].get<int>()];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            float low = mesh.vertices[part.first_vertex].position[axis];
            float high = low;
            for (std::size_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
                low = std::min(low, mesh.vertices[v].position[axis]);
                high = std::max(high, mesh.vertices[v].position[axis]);
            }
            EXPECT_EQ(low, accessor["min"][axis].get<float>());
            EXPECT_EQ(high, accessor["max"][axis].get<float>());
        }
    }
}

TEST(Glb, BoxesOfTheLongestNumbersFit) {
    const TemporaryFolder folder;
    SampleMesh mesh = sample_mesh(3);
    const float longest[] = {-1.17549435e-38f, -0.000123456782f, -1.40129846e-45f, -3.40282347e+38f};
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        for (float& x : mesh.vertices[i].position)
            x = longest[i % 4];
    }
    EXPECT_NO_THROW(write_sample(folder / "mesh.glb", mesh, 1));
    EXPECT_NO_THROW(read_glb(folder / "mesh.glb"));
}

TEST(Glb, NamesNeedNotBeUtf8) {
    const TemporaryFolder folder;
    SampleMesh mesh = sample_mesh(3);
    mesh.scene.materials[1].name = "caf\xe9 \"quoted\"\n";
    write_sample(folder / "mesh.glb", mesh, 1);
    EXPECT_EQ("caf\xef\xbf\xbd \"quoted\"\n", read_glb_file(folder / "mesh.glb").json["materials"][0]["name"]);
}

TEST(Glb, RefusesImagesItCannotEmbed) {
    const TemporaryFolder folder;
    SampleMesh mesh = textured_sample();
    mesh.scene.images[1].mime_type = "image/webp";
    EXPECT_THROW(write_sample(folder / "mesh.glb", mesh, 1), Error);
    EXPECT_EQ(0u, folder.entries());
}

}  // namespace
}  // namespace tessera::test
