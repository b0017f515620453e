// What metallic-roughness shading needs of a glTF file: maps, factors and lights, read only on demand.
#include "scene/gltf_builder.hpp"

#include "base/error.hpp"
#include "image/image.hpp"

#include <cmath>

namespace tessera::test {
namespace {

using json = nlohmann::json;

/// A triangle with two sets of coordinates and a material.
GltfBuilder with_material(json material) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "image.png";
    image::write_png({2, 1, {255, 0, 0, 255, 0, 255, 0, 255}}, path);
    std::ifstream in(path, std::ios::binary);
    const std::string png{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    GltfBuilder builder;
    const int positions = builder.add_positions(triangle_positions);
    const int first = builder.add("VEC2", 5126, std::vector<float>{0, 0, 1, 0, 0, 1});
    const int second = builder.add("VEC2", 5126, std::vector<float>{0.5, 0, 0.5, 1, 0.5, 0.5});
    builder.push("images", {{"uri", "data:image/png;base64," + base64(png)}});
    builder.push("samplers", {{"wrapS", 33071}, {"wrapT", 33648}});
    builder.push("textures", {{"source", 0}, {"sampler", 0}});
    builder.push("materials", std::move(material));
    builder.add_mesh_node(
        {{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", first}, {"TEXCOORD_1", second}}}, {"material", 0}});
    return builder;
}

scene::Scene load(const GltfBuilder& builder, bool all_maps = true) {
    const TemporaryFolder folder;
    return scene::load_scene(folder.write("model.gltf", builder.text()).string(), {.all_maps = all_maps});
}

const json full_material{
    {"pbrMetallicRoughness",
     {{"metallicFactor", 0.25}, {"roughnessFactor", 0.75}, {"metallicRoughnessTexture", {{"index", 0}}}}},
    {"normalTexture", {{"index", 0}, {"scale", 0.5}}},
    {"occlusionTexture", {{"index", 0}, {"strength", 0.125}}},
    {"emissiveTexture", {{"index", 0}}},
    {"emissiveFactor", {0.5, 0.25, 1}}};

TEST(Maps, AndFactorsAreRead) {
    const scene::Scene scene = load(with_material(full_material));
    expect_sound(scene);
    const scene::Material& material = scene.materials.at(0);
    EXPECT_FALSE(material.base_color_image);
    EXPECT_EQ(material.metallic, 0.25f);
    EXPECT_EQ(material.roughness, 0.75f);
    EXPECT_EQ(material.emissive, glm::vec3(0.5f, 0.25f, 1.0f));
    ASSERT_TRUE(material.maps.metallic_roughness && material.maps.normal && material.maps.occlusion &&
                material.maps.emissive);
    EXPECT_EQ(material.maps.normal->image, 0u);
    EXPECT_EQ(material.maps.normal->wrap_u, scene::Wrap::clamp);
    EXPECT_EQ(material.maps.normal->wrap_v, scene::Wrap::mirror);
    EXPECT_EQ(material.maps.normal_scale, 0.5f);
    EXPECT_EQ(material.maps.occlusion_strength, 0.125f);
    EXPECT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.meshes.at(0).uvs.at(1), glm::vec2(1, 0));
    EXPECT_FALSE(material.unlit);
}

TEST(Maps, AreLeftOutUnlessAskedFor) {
    const scene::Scene scene = load(with_material(full_material), false);
    EXPECT_FALSE(scene.materials.at(0).maps.normal);
    EXPECT_TRUE(scene.images.empty());
    EXPECT_TRUE(has_message(scene, "only base colours"));
}

// Vertices carry the coordinates of the base colour; a map's own are made from them.
TEST(Maps, HaveTransformsOfTheirOwn) {
    const auto use = [](double offset, double scale) {
        return json{{"index", 0},
                    {"extensions", {{"KHR_texture_transform", {{"offset", {offset, 0}}, {"scale", {scale, scale}}}}}}};
    };
    const scene::Scene scene = load(
        with_material({{"pbrMetallicRoughness", {{"baseColorTexture", use(1, 2)}}}, {"normalTexture", use(3, 8)}}));
    const glm::vec2 carried = scene.meshes.at(0).uvs.at(1);
    EXPECT_EQ(carried, glm::vec2(3, 0));
    EXPECT_EQ(scene.materials.at(0).maps.normal.value().transform * glm::vec3(carried, 1.0f), glm::vec3(11, 0, 1));
}

TEST(Maps, OfAnotherSetOfCoordinatesAreLeftOut) {
    const scene::Scene scene = load(with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                                   {"occlusionTexture", {{"index", 0}, {"texCoord", 1}}}}));
    EXPECT_FALSE(scene.materials.at(0).maps.occlusion);
    EXPECT_TRUE(has_message(scene, "materials[0].occlusionTexture uses TEXCOORD_1"));
}

TEST(Materials, MayBeUnlitAndGlow) {
    const scene::Scene scene = load(with_material(
        {{"emissiveFactor", {1, 0.5, 0}},
         {"extensions",
          {{"KHR_materials_unlit", json::object()}, {"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}}));
    EXPECT_TRUE(scene.materials.at(0).unlit);
    EXPECT_EQ(scene.materials.at(0).emissive, glm::vec3(4, 2, 0));
}

GltfBuilder with_light(json light) {
    GltfBuilder builder = with_material(json::object());
    builder.document["extensions"]["KHR_lights_punctual"]["lights"] = json::array({std::move(light)});
    const double half = std::sqrt(0.5);
    builder.push("nodes", {{"rotation", {0, half, 0, half}},  // -z to -x
                           {"translation", {1, 2, 3}},
                           {"scale", {5, 5, 5}},
                           {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return builder;
}

TEST(Lights, StandWhereTheirNodesAre) {
    const json spot{{"type", "spot"},
                    {"color", {1, 0.5, 0}},
                    {"intensity", 8},
                    {"range", 9},
                    {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.5}}}};
    const scene::Scene scene = load(with_light(spot));
    ASSERT_EQ(scene.lights.size(), 1u);
    const scene::Light& light = scene.lights[0];
    EXPECT_EQ(light.kind, scene::Light::Kind::spot);
    EXPECT_EQ(light.place, glm::vec3(1, 2, 3));
    EXPECT_LT(glm::length(light.direction - glm::vec3(-1, 0, 0)), 1e-6f);
    EXPECT_EQ(light.intensity, glm::vec3(8, 4, 0));
    EXPECT_EQ(light.range, 9.0f);
    // The extension's formula: 1 at the inner angle, 0 at the outer.
    EXPECT_NEAR(std::cos(0.2f) * light.cone_scale + light.cone_offset, 1.0f, 1e-5f);
    EXPECT_NEAR(std::cos(0.5f) * light.cone_scale + light.cone_offset, 0.0f, 1e-5f);
    EXPECT_TRUE(load(with_light(spot), false).lights.empty());
    const scene::Scene sun = load(with_light({{"type", "directional"}}));
    ASSERT_EQ(sun.lights.size(), 1u);
    EXPECT_LT(glm::length(sun.lights[0].direction - glm::vec3(1, 0, 0)), 1e-6f) << "towards the light";
}

TEST(Lights, WithValuesThatMakeNoSenseAreLeftOutOrRefused) {
    const scene::Scene scene = load(with_light({{"type", "point"}, {"intensity", -1}}));
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_TRUE(has_message(scene, "Light 0 is left out"));
    EXPECT_THROW(load(with_light({{"type", "laser"}})), Error);
    GltfBuilder builder = with_light({{"type", "point"}});
    builder.document["nodes"].back()["extensions"]["KHR_lights_punctual"]["light"] = 1;
    EXPECT_THROW(load(builder), Error);
}

}  // namespace
}  // namespace tessera::test
