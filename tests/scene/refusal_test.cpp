// Unsound documents: each is refused with the element that is wrong.
#include "scene/gltf_builder.hpp"

#include "scene/limits.hpp"

#include <functional>

namespace tessera::test {
namespace {

using json = nlohmann::json;

/// A sound file with one of everything: an indexed triangle with a sparse accessor, normals, a morph target, a skin,
/// a texture, a material, a camera and a scene.
GltfBuilder sound_file() {
    GltfBuilder builder;
    const int positions = builder.add_positions(triangle_positions);                       // accessor 0
    const int indices = builder.add("SCALAR", 5123, std::vector<std::uint16_t>{0, 1, 2});  // 1
    const int normals = builder.add_positions({0, 0, 1, 0, 0, 1, 0, 0, 1});                // 2
    const int joints = builder.add("VEC4", 5121, std::vector<std::uint8_t>(12, 0));        // 3
    const int weights = builder.add("VEC4", 5126, std::vector<float>(12, 0.25f));          // 4
    const int uvs = builder.add("VEC2", 5126, std::vector<float>(6, 0.5f));                // 5
    const int matrices =
        builder.add("MAT4", 5126, std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});  // 6
    const int target = builder.add_positions(std::vector<float>(9, 0.0f));                              // 7
    const int sparse_indices = builder.add_view(std::vector<std::uint8_t>{0, 2});                       // view 8
    const int sparse_values = builder.add_view(std::vector<float>{0, 0, 0, 0, 1, 0});                   // view 9
    builder.document["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", sparse_indices}, {"componentType", 5121}}},
        {"values", {{"bufferView", sparse_values}}}};
    builder.add_mesh_node({{"attributes",
                            {{"POSITION", positions},
                             {"NORMAL", normals},
                             {"JOINTS_0", joints},
                             {"WEIGHTS_0", weights},
                             {"TEXCOORD_0", uvs}}},
                           {"indices", indices},
                           {"material", 0},
                           {"mode", 4},
                           {"targets", json::array({{{"POSITION", target}}})}});
    builder.document["meshes"][0]["weights"] = {0.5};
    builder.document["nodes"][0]["skin"] = 0;
    builder.push("nodes", {{"name", "joint"}, {"rotation", {0, 0, 0, 1}}});
    builder.push("skins", {{"joints", {1}}, {"inverseBindMatrices", matrices}});
    builder.push("images", {{"uri", "absent.png"}});
    builder.push("samplers", {{"wrapS", 10497}});
    builder.push("textures", {{"source", 0}, {"sampler", 0}});
    builder.push("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    builder.push("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.5}, {"zfar", 5}}}});
    builder.document["nodes"][1]["camera"] = 0;
    builder.push("scenes", {{"nodes", {0, 1}}});
    builder.document["scene"] = 0;
    builder.document["buffers"] = {{{"byteLength", builder.binary.size()},
                                    {"uri", "data:application/octet-stream;base64," + base64(builder.binary)}}};
    return builder;
}

struct Defect {
    const char* pointer;  ///< where in the JSON text
    json value;
    const char* sentence;  ///< part of it
};

TEST(Refusal, TheFileWithoutADefectIsSound) {
    expect_sound(sound_file().load());
}

TEST(Refusal, EveryDefectIsNamed) {
    const std::vector<Defect> defects{
        {"/asset", 1, "asset is 1, but must be an object"},
        {"/asset/version", 2.0, "asset.version is 2.0, but must be a string"},
        {"/asset/version", "3.0", "asset.version is \"3.0\""},
        {"/asset/minVersion", "2.1", "asset.minVersion is \"2.1\""},
        {"/extensionsRequired", {"KHR_\x1b[31m"}, "\"KHR_\\x1b[31m\", which is not supported"},
        {"/extensionsRequired", "KHR_x", "extensionsRequired is \"KHR_x\", but must be an array"},
        {"/accessors", json::object(), "accessors is an object, but must be an array"},
        {"/accessors/0", nullptr, "accessors[0] is null, but must be an object"},
        {"/accessors/0/bufferView", 10, "accessors[0].bufferView is 10, but must be an index below 10"},
        {"/accessors/0/bufferView", -1, "accessors[0].bufferView is -1"},
        {"/accessors/0/bufferView", 0.5, "accessors[0].bufferView is 0.5"},
        {"/accessors/0/bufferView", 4294967296, "accessors[0].bufferView is 4294967296"},
        {"/accessors/0/byteOffset", 1, "accessors[0] needs 37 bytes of bufferViews[0], which has 36"},
        {"/accessors/0/byteOffset", -4, "accessors[0].byteOffset is -4"},
        {"/accessors/0/byteOffset", 18446744073709551615u, "accessors[0].byteOffset is 18446744073709551615"},
        {"/accessors/0/componentType", 5124, "accessors[0].componentType is 5124"},
        {"/accessors/0/componentType", 5130, "accessors[0].componentType is 5130"},
        {"/accessors/0/componentType", 5125, "\"POSITION\" is accessor 0"},
        {"/accessors/0/count", 0, "accessors[0].count is 0"},
        {"/accessors/0/count", 4, "accessors[0] needs 48 bytes"},
        {"/accessors/0/count", 2147483647, "accessors[0] needs 25769803764 bytes"},
        {"/accessors/0/count", 1e9, "accessors[0].count is 1000000000.0"},
        {"/accessors/0/count", "3", "accessors[0].count is \"3\""},
        {"/accessors/0/normalized", 1, "accessors[0].normalized is 1, but must be true or false"},
        {"/accessors/0/type", "VEC5", "accessors[0].type is \"VEC5\""},
        {"/accessors/0/type", "VEC2", "\"POSITION\" is accessor 0 with 2 values"},
        {"/accessors/0/sparse", 1, "accessors[0].sparse is 1"},
        {"/accessors/0/sparse/count", 0, "accessors[0].sparse.count is 0"},
        {"/accessors/0/sparse/count", 4, "accessors[0].sparse.count is 4, more than the 3"},
        {"/accessors/0/sparse/count", 3, "accessors[0].sparse.indices needs 3 bytes"},
        {"/accessors/0/sparse/indices/componentType", 5122, "sparse.indices.componentType is 5122"},
        {"/accessors/0/sparse/indices/componentType", 5125, "accessors[0].sparse.indices needs 8 bytes"},
        {"/accessors/0/sparse/indices/byteOffset", 2147483647, "accessors[0].sparse.indices needs"},
        {"/accessors/0/sparse/indices/bufferView", 99, "sparse.indices.bufferView is 99"},
        {"/accessors/0/sparse/indices/bufferView", 9, "accessors[0].sparse.indices holds 0 at place 1"},
        {"/accessors/0/sparse/values/byteOffset", 4, "accessors[0].sparse.values needs 28 bytes"},
        {"/accessors/1/componentType", 5120, "meshes[0].primitives[0].indices is accessor 1"},
        {"/accessors/1/componentType", 5122, "meshes[0].primitives[0].indices is accessor 1"},
        {"/accessors/1/normalized", true, "meshes[0].primitives[0].indices are normalised"},
        {"/accessors/1", json{{"componentType", 5123}, {"count", 3}, {"type", "SCALAR"}}, "has no bufferView"},
        {"/accessors/2/count", 2, "\"NORMAL\" has 2 elements, but POSITION has 3"},
        {"/accessors/3/componentType", 5120, "\"JOINTS_0\" is accessor 3"},
        {"/accessors/6/type", "VEC4", "skins[0].inverseBindMatrices is accessor 6"},
        {"/accessors/7/count", 1, "targets[0].\"POSITION\" has 1 elements"},
        {"/buffers/0/byteLength", -1, "buffers[0].byteLength is -1"},
        {"/buffers/0/byteLength", 2147483647, "buffers[0].byteLength is 2147483647, but there are only"},
        {"/buffers/0/byteLength", 100, "bufferViews["},
        {"/buffers/0/uri", "", "buffers[0].uri is empty"},
        {"/buffers/0/uri", 1, "buffers[0].uri is 1"},
        {"/buffers/0", json{{"byteLength", 4}}, "buffers[0] has no uri"},
        {"/bufferViews/0/buffer", 1, "bufferViews[0].buffer is 1"},
        {"/bufferViews/0/byteLength", 0, "bufferViews[0].byteLength is 0"},
        {"/bufferViews/0/byteLength", 2147483647, "bufferViews[0] ends at byte 2147483647"},
        {"/bufferViews/0/byteLength", 35, "accessors[0] needs 36 bytes of bufferViews[0], which has 35"},
        {"/bufferViews/0/byteOffset", 2147483647, "bufferViews[0] ends at byte 2147483683"},
        {"/bufferViews/0/byteStride", 6, "bufferViews[0].byteStride is 6, not a multiple of 4"},
        {"/bufferViews/0/byteStride", 8, "elements of 12 bytes, but its view a byteStride of 8"},
        {"/bufferViews/0/byteStride", 16, "accessors[0] needs 44 bytes"},
        {"/images/0", json::object(), "images[0].uri and bufferView"},
        {"/images/0/bufferView", 0, "images[0].uri and bufferView"},
        {"/materials/0/alphaMode", "CLEAR", "materials[0].alphaMode is \"CLEAR\""},
        {"/materials/0/doubleSided", "yes", "materials[0].doubleSided is \"yes\""},
        {"/materials/0/pbrMetallicRoughness", 1, "materials[0].pbrMetallicRoughness is 1"},
        {"/materials/0/pbrMetallicRoughness/baseColorFactor", {1, 1, 1}, "has 3 entries, but must have 4"},
        {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", 1, "baseColorTexture.index is 1"},
        {"/materials/0/pbrMetallicRoughness/baseColorTexture/texCoord", -1, "baseColorTexture.texCoord is -1"},
        {"/materials/0/pbrMetallicRoughness/baseColorTexture/extensions",
         {{"KHR_texture_transform", {{"scale", 1}}}},
         "KHR_texture_transform.scale is 1, but must be an array"},
        {"/meshes/0/primitives", nullptr, "meshes[0].primitives is null"},
        {"/meshes/0", json::object(), "meshes[0].primitives is missing"},
        {"/meshes/0/primitives/0/attributes", json::array(), "primitives[0].attributes is an array"},
        {"/meshes/0/primitives/0/attributes/POSITION", 8, "attributes.POSITION is 8, but must be an index below 8"},
        {"/meshes/0/primitives/0/attributes/POSITION", 4294967296, "attributes.POSITION is 4294967296"},
        {"/meshes/0/primitives/0/attributes/JOINTS_1", 3, "has only one of JOINTS_1 and WEIGHTS_1"},
        {"/meshes/0/primitives/0/indices", 3.5, "primitives[0].indices is 3.5"},
        {"/meshes/0/primitives/0/material", 1, "primitives[0].material is 1"},
        {"/meshes/0/primitives/0/mode", 7, "primitives[0].mode is 7"},
        {"/meshes/0/primitives/0/targets", {1}, "targets[0] is 1, but must be an object"},
        {"/meshes/0/primitives/0/targets/0/POSITION", -2, "targets[0].POSITION is -2"},
        {"/meshes/0/weights", {1, 2}, "meshes[0].weights has 2 values, but the mesh has 1 morph targets"},
        {"/meshes/0/weights", {"a"}, "meshes[0].weights holds \"a\""},
        {"/nodes/0/children", {2}, "nodes[0].children[0] is 2"},
        {"/nodes/0/mesh", -1, "nodes[0].mesh is -1"},
        {"/nodes/0/skin", 1, "nodes[0].skin is 1"},
        {"/nodes/0/matrix", {1, 2, 3}, "nodes[0].matrix has 3 entries, but must have 16"},
        {"/nodes/1/rotation", {0, 0, 0, 0}, "nodes[1].rotation has no usable length"},
        {"/nodes/1/rotation", {0, 0, 0, nullptr}, "nodes[1].rotation holds null"},
        {"/nodes/1/name", 5, "nodes[1].name is 5"},
        {"/scene", 1, "scene is 1"},
        {"/scenes/0/nodes", {0, 5}, "scenes[0].nodes[1] is 5"},
        {"/skins/0/joints", json::array(), "skins[0].joints is empty"},
        {"/skins/0/joints", {1, 1}, "skins[0].inverseBindMatrices has 1 matrices for 2 joints"},
        {"/skins/0/inverseBindMatrices", 8, "skins[0].inverseBindMatrices is 8"},
        {"/textures/0/source", 1, "textures[0].source is 1"},
        {"/textures/0/sampler", 1, "textures[0].sampler is 1"},
    };
    for (const Defect& defect : defects) {
        GltfBuilder builder = sound_file();
        builder.document[json::json_pointer(defect.pointer)] = defect.value;
        const std::string sentence = refusal(builder);
        EXPECT_NE(sentence.find(defect.sentence), std::string::npos) << defect.pointer << ": " << sentence;
        EXPECT_NE(sentence.find("model.gltf: "), std::string::npos) << sentence;
        EXPECT_EQ(sentence.back(), '.') << sentence;
    }
}

/// Replaces every value in the file by values of every type, one at a time: each must load soundly or be refused.
TEST(Refusal, AnyValueMayHaveAnyType) {
    const GltfBuilder sound = sound_file();
    const std::vector<json> values{nullptr,
                                   true,
                                   -1,
                                   0,
                                   1,
                                   1e300,
                                   -0.5,
                                   4294967297.0,
                                   "x",
                                   json::array(),
                                   json{1},
                                   json::object(),
                                   json{{"x", 1}},
                                   9223372036854775807,
                                   18446744073709551615u,
                                   2147483647,
                                   -2147483649ll};
    const json flat = sound.document.flatten();
    std::vector<std::string> pointers;
    for (const auto& [pointer, value] : flat.items()) {
        // Every leaf and every container above it.
        for (std::size_t end = pointer.size(); end != std::string::npos && end > 0; end = pointer.rfind('/', end - 1)) {
            pointers.push_back(pointer.substr(0, end));
        }
    }
    std::sort(pointers.begin(), pointers.end());
    pointers.erase(std::unique(pointers.begin(), pointers.end()), pointers.end());
    const TemporaryFolder folder;
    int loaded = 0;
    int refused = 0;
    for (const std::string& pointer : pointers) {
        for (const json& value : values) {
            GltfBuilder builder = sound;
            builder.document[json::json_pointer(pointer)] = value;
            SCOPED_TRACE(pointer + " = " + value.dump());
            try {
                expect_sound(scene::load_scene(folder.write("model.gltf", builder.text()).string()));
                ++loaded;
            } catch (const Error& error) {
                ASSERT_EQ(error.kind(), ErrorKind::usage);
                ++refused;
            }
        }
    }
    EXPECT_GT(loaded, 100);
    EXPECT_GT(refused, 1000);
}

TEST(Refusal, DeepAndLargeJsonIsRefusedBeforeItIsKept) {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& text) { return refusal(folder.write("model.gltf", text).string()); };
    const std::string deep = "{\"extras\":" + std::string(1'000'000, '[');
    EXPECT_NE(refused(deep).find("nested deeper than 64"), std::string::npos);
    std::string wide = "{\"extras\":[0";
    for (std::uint64_t i = 0; i < scene::max_json_values; ++i)
        wide += ",0";
    EXPECT_NE(refused(wide + "]}").find("holds more than"), std::string::npos);
    EXPECT_NE(refused("{\"asset\":{\"version\":\"2.0\"},\"extras\":1e999}").find("cannot be parsed"),
              std::string::npos);
    EXPECT_NE(refused("{\"asset\":{\"version\":\"\xff\"}}").find("cannot be parsed"), std::string::npos);
    EXPECT_NE(refused("{}").find("asset is missing"), std::string::npos);
}

TEST(Refusal, ArraysLongerThanTheLimitAreRefused) {
    const TemporaryFolder folder;
    std::string text = R"({"asset":{"version":"2.0"},"nodes":[{})";
    for (std::uint64_t i = 0; i < scene::max_elements; ++i)
        text += ",{}";
    EXPECT_NE(refusal(folder.write("model.gltf", text + "]}").string()).find("nodes has 1048577 entries"),
              std::string::npos);
}

TEST(Refusal, WhatASmallFileMayAskForIsLimited) {
    GltfBuilder zeros;
    const int positions = zeros.add_positions(triangle_positions);
    zeros.document["accessors"][static_cast<std::size_t>(positions)] = {
        {"componentType", 5126}, {"count", 2147483647}, {"type", "VEC3"}};
    zeros.add_mesh_node({{"attributes", {{"POSITION", positions}}}});
    EXPECT_NE(refusal(zeros).find("accessors[0].count is 2147483647 without a bufferView"), std::string::npos);

    // Many nodes that show one mesh, or many primitives over the same data, multiply what a file holds.
    GltfBuilder instances;
    const int many = instances.add_positions(std::vector<float>(3 * 3000, 1.0f));
    instances.add_mesh_node({{"attributes", {{"POSITION", many}}}});
    for (int i = 0; i < 30'000; ++i)
        instances.document["nodes"].push_back({{"mesh", 0}, {"scale", {0, 0, 0}}});
    EXPECT_TRUE(has_message(instances.load(), "further messages are not shown")) << "skipped nodes cost nothing";
    GltfBuilder primitives = instances;
    for (int i = 0; i < 30'000; ++i)
        instances.document["nodes"][static_cast<std::size_t>(i)]["scale"] = {1, 1, 1};
    EXPECT_NE(refusal(instances).find("brings the model to 67110000 vertices, more than the"), std::string::npos);
    for (int i = 0; i < 30'000; ++i) {
        primitives.document["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", many}}}});
    }
    EXPECT_NE(refusal(primitives).find("vertices, more than the"), std::string::npos);
}

}  // namespace
}  // namespace tessera::test
