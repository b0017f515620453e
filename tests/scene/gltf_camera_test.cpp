// Cameras of glTF files: where they stand, and values that make no camera.
#include "scene/gltf_builder.hpp"

#include <cmath>

namespace tessera::test {
namespace {

using json = nlohmann::json;

GltfBuilder with_camera(json camera, json node = json::object()) {
    GltfBuilder builder;
    builder.add_mesh_node({{"attributes", {{"POSITION", builder.add_positions(triangle_positions)}}}});
    node["camera"] = builder.push("cameras", std::move(camera));
    builder.push("nodes", std::move(node));
    return builder;
}

json perspective(json values = json::object()) {
    json all{{"yfov", 1.0}, {"znear", 0.5}};
    all.update(values);
    return {{"type", "perspective"}, {"perspective", all}};
}

json orthographic(json values = json::object()) {
    json all{{"xmag", 2.0}, {"ymag", 3.0}, {"znear", 0.0}, {"zfar", 9.0}};
    all.update(values);
    return {{"type", "orthographic"}, {"orthographic", all}};
}

TEST(Cameras, StandWhereTheirNodesAre) {
    const double half = std::sqrt(0.5);
    // A quarter turn around y takes the view from -z to -x; the scale is no matter of cameras.
    GltfBuilder builder = with_camera(
        perspective({{"aspectRatio", 2.0}, {"zfar", 7.0}}),
        {{"name", "side"}, {"rotation", {0, half, 0, half}}, {"translation", {1, 2, 3}}, {"scale", {5, 6, 7}}});
    builder.push("nodes", {{"children", {1}}, {"translation", {10, 0, 0}}});
    const scene::Scene scene = builder.load();
    expect_sound(scene);
    ASSERT_EQ(scene.cameras.size(), 1u);
    const scene::Camera& camera = scene.cameras[0];
    EXPECT_EQ(camera.name, "side");
    EXPECT_EQ(camera.eye, glm::dvec3(11, 2, 3));
    EXPECT_LT(glm::length(camera.axes[0] - glm::dvec3(0, 0, -1)), 1e-12);
    EXPECT_LT(glm::length(camera.axes[1] - glm::dvec3(0, 1, 0)), 1e-12);
    EXPECT_LT(glm::length(camera.axes[2] - glm::dvec3(1, 0, 0)), 1e-12);
    EXPECT_FALSE(camera.orthographic);
    EXPECT_DOUBLE_EQ(camera.half_height, std::tan(0.5));
    EXPECT_DOUBLE_EQ(camera.half_width, 2.0 * std::tan(0.5));
    EXPECT_EQ(camera.near_plane, 0.5);
    EXPECT_EQ(camera.far_plane, 7.0);
}

TEST(Cameras, WithoutFarPlaneSeeForEver) {
    const scene::Scene scene = with_camera(perspective()).load();
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_TRUE(std::isinf(scene.cameras[0].far_plane));
    EXPECT_EQ(scene.cameras[0].half_width, 0.0);
    EXPECT_TRUE(scene.messages.empty());
}

TEST(Cameras, MayBeOrthographic) {
    json camera = orthographic();
    camera["name"] = "plan";
    const scene::Scene scene = with_camera(camera).load();
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].name, "plan");
    EXPECT_TRUE(scene.cameras[0].orthographic);
    EXPECT_EQ(scene.cameras[0].half_width, 2.0);
    EXPECT_EQ(scene.cameras[0].half_height, 3.0);
    EXPECT_EQ(scene.cameras[0].far_plane, 9.0);
}

TEST(Cameras, AreThoseOfTheSceneShownOneForEachNode) {
    GltfBuilder builder = with_camera(perspective(), {{"name", "first"}});
    builder.push("nodes", {{"camera", 0}, {"name", "second"}});
    builder.push("cameras", orthographic());
    builder.push("nodes", {{"camera", 1}, {"name", "elsewhere"}});
    builder.push("scenes", {{"nodes", {0, 2, 1}}});
    const scene::Scene scene = builder.load();
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].name, "second");
    EXPECT_EQ(scene.cameras[1].name, "first");
    EXPECT_TRUE(has_message(scene, "cameras[1] is left out: no node of the scene carries it."));
}

TEST(Cameras, WithValuesThatMakeNoneAreLeftOut) {
    const std::vector<std::pair<json, std::string>> cases{
        {perspective({{"yfov", 0}}), "yfov"},
        {perspective({{"yfov", -1}}), "yfov"},
        {perspective({{"yfov", 3.2}}), "yfov"},
        {perspective({{"yfov", 1e308}}), "yfov"},
        {perspective({{"aspectRatio", 0}}), "aspectRatio"},
        {perspective({{"aspectRatio", -2}}), "aspectRatio"},
        {perspective({{"aspectRatio", 1e308}, {"yfov", 3.1}}), "aspectRatio"},
        {perspective({{"znear", 0}}), "znear"},
        {perspective({{"znear", -1}}), "znear"},
        {perspective({{"zfar", 0.5}}), "zfar"},
        {perspective({{"zfar", -3}}), "zfar"},
        {{{"type", "perspective"}}, "yfov"},
        {{{"type", "perspective"}, {"perspective", {{"yfov", 1}}}}, "znear"},
        {orthographic({{"xmag", 0}}), "xmag"},
        {orthographic({{"xmag", -1}}), "xmag"},
        {orthographic({{"ymag", 0}}), "ymag"},
        {orthographic({{"znear", -1}}), "znear"},
        {orthographic({{"zfar", 0}}), "zfar"},
        {{{"type", "orthographic"}}, "xmag"},
        {{{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0}}}}, "zfar"},
    };
    for (const auto& [camera, word] : cases) {
        const scene::Scene scene = with_camera(camera).load();
        EXPECT_EQ(scene.meshes.size(), 1u);
        EXPECT_TRUE(scene.cameras.empty()) << camera;
        ASSERT_EQ(scene.messages.size(), 1u);
        EXPECT_NE(scene.messages[0].find("cameras[0] is left out: its "), std::string::npos) << scene.messages[0];
        EXPECT_NE(scene.messages[0].find(word), std::string::npos) << scene.messages[0];
    }
}

TEST(Cameras, WithoutDirectionAreLeftOut) {
    for (const json& node : {json{{"scale", {1, 0, 1}}}, json{{"scale", {1, 1, 0}}}, json{{"scale", {0, 0, 0}}},
                             json{{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1}}}}) {
        const scene::Scene scene = with_camera(perspective(), node).load();
        EXPECT_TRUE(scene.cameras.empty()) << node;
        EXPECT_TRUE(has_message(scene, "no direction")) << node;
    }
    // Shear and size are taken out, however small or large.
    for (const double size : {1e-200, 1.0, 1e200}) {
        const scene::Scene scene =
            with_camera(perspective(), {{"matrix", {size, 0, 0, 0, 0, size, size, 0, 0, 0, size, 0, 0, 0, 0, 1}}})
                .load();
        expect_sound(scene);
        EXPECT_EQ(scene.cameras.size(), 1u) << size;
    }
}

TEST(Cameras, OfWrongTypesAreRefused) {
    const auto refused = [](const char* pointer, const json& value) {
        GltfBuilder builder = with_camera(perspective());
        builder.document[json::json_pointer(pointer)] = value;
        return refusal(builder);
    };
    EXPECT_NE(refused("/cameras/0/type", "fisheye").find("cameras[0].type is \"fisheye\""), std::string::npos);
    EXPECT_NE(refused("/cameras/0", json::object()).find("cameras[0].type is missing"), std::string::npos);
    EXPECT_NE(refused("/cameras/0/perspective/yfov", "wide").find("yfov is \"wide\", but must be a number"),
              std::string::npos);
    EXPECT_NE(refused("/cameras/0/perspective", 1).find("cameras[0].perspective is 1"), std::string::npos);
    EXPECT_NE(refused("/nodes/1/camera", 1).find("nodes[1].camera is 1, but must be an index below 1"),
              std::string::npos);
}

}  // namespace
}  // namespace tessera::test
