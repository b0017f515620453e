// Base colours, their textures and texture coordinates.
#include "scene/gltf_builder.hpp"

#include "image/image.hpp"

#include <cmath>

namespace tessera::test {
namespace {

using json = nlohmann::json;

/// A PNG of two pixels, red and green.
std::string png_bytes() {
    const TemporaryFolder folder;
    const auto path = folder.path() / "image.png";
    image::write_png({2, 1, {255, 0, 0, 255, 0, 255, 0, 255}}, path);
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// A triangle with two sets of texture coordinates and a textured material.
GltfBuilder textured_triangle(const std::string& image_uri) {
    GltfBuilder builder;
    const int positions = builder.add_positions(triangle_positions);
    const int first = builder.add("VEC2", 5126, std::vector<float>{0, 0, 1, 0, 0, 1});
    const int second = builder.add("VEC2", 5126, std::vector<float>{0.5, 0, 0.5, 1, 0.5, 0.5});
    builder.push("images", {{"uri", image_uri}});
    builder.push("textures", {{"source", 0}});
    builder.push("materials", {{"name", "skin"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    builder.add_mesh_node(
        {{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", first}, {"TEXCOORD_1", second}}}, {"material", 0}});
    return builder;
}

GltfBuilder textured_triangle() {
    return textured_triangle("data:image/png;base64," + base64(png_bytes()));
}

TEST(Materials, FactorsModesAndDefaultsAreRead) {
    GltfBuilder builder = textured_triangle();
    builder.push("materials", {{"pbrMetallicRoughness", {{"baseColorFactor", {0.25, 0.5, 1, 0}}}},
                               {"alphaMode", "MASK"},
                               {"alphaCutoff", 0.75},
                               {"doubleSided", true}});
    builder.push("materials", {{"alphaMode", "BLEND"}});
    builder.document["meshes"][0]["primitives"][0].erase("material");
    const scene::Scene scene = builder.load();
    ASSERT_EQ(scene.materials.size(), 4u) << "the file's three, and one for the primitive that has none";
    EXPECT_EQ(scene.materials[0].name, "skin");
    EXPECT_EQ(scene.materials[1].base_color, glm::vec4(0.25, 0.5, 1, 0));
    EXPECT_EQ(scene.materials[1].alpha_mode, scene::AlphaMode::mask);
    EXPECT_EQ(scene.materials[1].alpha_cutoff, 0.75f);
    EXPECT_TRUE(scene.materials[1].double_sided);
    EXPECT_EQ(scene.materials[2].alpha_mode, scene::AlphaMode::blend);
    EXPECT_EQ(scene.meshes.at(0).material, 3u);
    EXPECT_EQ(scene.materials[3].base_color, glm::vec4(1));
}

TEST(Materials, ImagesAreDecodedAndKeptEncoded) {
    const std::string png = png_bytes();
    const scene::Scene scene = textured_triangle().load();
    expect_sound(scene);
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.images[0].mime_type, "image/png");
    EXPECT_EQ(scene.images[0].encoded.size(), png.size());
    EXPECT_EQ(scene.images[0].pixels.width, 2u);
    EXPECT_EQ(scene.images[0].pixels.rgba[5], 255);
    EXPECT_EQ(scene.materials[0].base_color_image, 0u);
}

TEST(Materials, ImagesComeFromBufferViewsToo) {
    const std::string png = png_bytes();
    GltfBuilder builder = textured_triangle();
    const int view = builder.add_view(std::vector<char>(png.begin(), png.end()));
    builder.document["images"][0] = {{"bufferView", view}, {"mimeType", "image/png"}};
    EXPECT_EQ(builder.load("model.glb").images.size(), 1u);
}

TEST(Materials, AnImageIsLoadedOnceAndOnlyIfABaseColourUsesIt) {
    GltfBuilder builder = textured_triangle();
    builder.push("images", {{"uri", "absent.png"}});
    builder.push("textures", {{"source", 1}});
    builder.push("textures", {{"source", 0}});
    builder.push("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 2}}}}}});
    builder.push("materials", {{"normalTexture", {{"index", 1}}}});
    const scene::Scene scene = builder.load();
    EXPECT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.materials[1].base_color_image, 0u);
    EXPECT_TRUE(has_message(scene, "other textures are ignored"));
}

TEST(Materials, AnImageThatCannotBeReadIsLeftOutWithAMessage) {
    std::string cut = png_bytes();
    cut.resize(cut.size() / 2);
    for (const std::string& uri : {std::string("absent.png"), std::string("../outside.png"), std::string("/dev/zero"),
                                   "data:image/png;base64," + base64("GIF89a"), std::string("data:image/png,raw"),
                                   "data:image/png;base64," + base64(cut)}) {
        const scene::Scene scene = textured_triangle(uri).load();
        EXPECT_EQ(scene.meshes.size(), 1u);
        EXPECT_TRUE(scene.images.empty()) << uri;
        EXPECT_FALSE(scene.materials[0].base_color_image.has_value());
        EXPECT_TRUE(has_message(scene, "it is left out")) << uri;
    }
}

TEST(Materials, TheTextureChoosesTheSetOfCoordinates) {
    GltfBuilder builder = textured_triangle();
    auto& info = builder.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
    EXPECT_EQ(builder.load().meshes.at(0).uvs[1], glm::vec2(1, 0));
    info["texCoord"] = 1;
    EXPECT_EQ(builder.load().meshes.at(0).uvs[1], glm::vec2(0.5, 1));
    info["extensions"]["KHR_texture_transform"]["texCoord"] = 0;
    EXPECT_EQ(builder.load().meshes.at(0).uvs[1], glm::vec2(1, 0));
    info["extensions"]["KHR_texture_transform"]["texCoord"] = 7;
    const scene::Scene scene = builder.load();
    EXPECT_EQ(scene.meshes.at(0).uvs[1], glm::vec2(0, 0));
    EXPECT_TRUE(has_message(scene, "no TEXCOORD_7"));
}

TEST(Materials, TextureTransformsAreApplied) {
    GltfBuilder builder = textured_triangle();
    builder.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
        {"KHR_texture_transform", {{"offset", {0.5, 1}}, {"rotation", std::acos(-1.0) / 2}, {"scale", {2, 3}}}}};
    const scene::Mesh mesh = builder.load().meshes.at(0);
    EXPECT_EQ(mesh.uvs[0], glm::vec2(0.5, 1));
    // Scaled, then a quarter turn counter-clockwise as seen with v pointing down: u goes up, v goes to the right.
    EXPECT_LT(glm::length(mesh.uvs[1] - glm::vec2(0.5, -1)), 1e-6f);
    EXPECT_LT(glm::length(mesh.uvs[2] - glm::vec2(3.5, 1)), 1e-6f);
}

TEST(Materials, SamplersThatDoNotRepeatAreToldOnlyWhereItShows) {
    GltfBuilder builder = textured_triangle();
    builder.push("samplers", {{"wrapS", 33071}});
    builder.document["textures"][0]["sampler"] = 0;
    EXPECT_FALSE(has_message(builder.load(), "repeated"));
    builder.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
        {"KHR_texture_transform", {{"scale", {2, 2}}}}};
    EXPECT_TRUE(has_message(builder.load(), "repeated beyond [0, 1]"));
}

TEST(Materials, ValuesOutOfRangeAreClampedWithAMessage) {
    GltfBuilder builder = textured_triangle();
    builder.document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {2, -1, 0.5, 1};
    const scene::Scene scene = builder.load();
    EXPECT_EQ(scene.materials[0].base_color, glm::vec4(1, 0, 0.5, 1));
    EXPECT_TRUE(has_message(scene, "clamped"));
}

}  // namespace
}  // namespace tessera::test
