// Damaged files: whatever the bytes, the loader loads something sound or refuses with an Error. Seeds are fixed, so a
// failure repeats; under the sanitizers this also finds reads out of bounds.
#include "scene/gltf_builder.hpp"

#include <rapidcheck/gtest.h>
#include <cstdint>
#include <random>

namespace tessera::test {
namespace {

/// A GLB with a strip, sparse positions, normals, a skin and two nodes: something for most readers.
std::string small_glb() {
    GltfBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1});
    const int normals = builder.add("VEC3", 5120, std::vector<std::int8_t>{0, 0, 9, 0, 9, 0, 9, 0, 0, 1, 2, 3}, 4);
    const int joints = builder.add("VEC4", 5121, std::vector<std::uint8_t>(16, 0));
    const int weights = builder.add("VEC4", 5121, std::vector<std::uint8_t>(16, 99));
    const int indices = builder.add("SCALAR", 5121, std::vector<std::uint8_t>{0, 1, 2, 3});
    const int places = builder.add_view(std::vector<std::uint8_t>{1, 3});
    const int values = builder.add_view(std::vector<float>{2, 0, 0, 2, 2, 2});
    builder.document["accessors"][static_cast<std::size_t>(positions)]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", places}, {"componentType", 5121}}},
        {"values", {{"bufferView", values}}}};
    builder.add_mesh_node(
        {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
         {"indices", indices},
         {"mode", 5}});
    builder.push("nodes", {{"mesh", 0}, {"skin", 0}, {"children", {0}}, {"scale", {1, -1, 2}}});
    builder.push("skins", {{"joints", {0}}});
    return builder.glb();
}

/// A GLB with guide curves: a strip and lines, with normals, widths and a mirroring node.
std::string hairy_glb() {
    GltfBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 0, 1, 0, 0, 2, 1, 1, 0, 0, 1, 1, 0});
    const int normals =
        builder.add("VEC3", 5120, std::vector<std::int8_t>{0, 0, 9, 0, 9, 0, 9, 0, 0, 1, 2, 3, 0, 0, 1}, 4);
    const int widths = builder.add("SCALAR", 5126, std::vector<float>{1, 1, 1, 0.5f, 0});
    const int strip = builder.add("SCALAR", 5121, std::vector<std::uint8_t>{0, 1, 2});
    const int lines = builder.add("SCALAR", 5121, std::vector<std::uint8_t>{0, 1, 1, 2, 3, 4});
    nlohmann::json primitives;
    for (const int indices : {strip, lines}) {
        primitives.push_back({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"_WIDTH", widths}}},
                              {"indices", indices},
                              {"mode", indices == strip ? 3 : 1}});
    }
    builder.push("meshes", {{"primitives", primitives}});
    builder.push("nodes", {{"mesh", 0}, {"scale", {1, -1, 2}}});
    return builder.glb();
}

class Damaged {
public:
    void expect_load_or_error(const std::string& bytes) {
        const auto path = folder_.write("model.glb", bytes).string();
        try {
            expect_sound(scene::load_scene(path));
            ++loaded;
        } catch (const Error& error) {
            ASSERT_EQ(error.kind(), ErrorKind::usage);
            ++refused;
        }
    }
    int loaded = 0;
    int refused = 0;

private:
    TemporaryFolder folder_;
};

TEST(Fuzz, EveryTruncationIsRefused) {
    const std::string glb = small_glb();
    Damaged damaged;
    for (std::size_t size = 0; size < glb.size(); ++size)
        damaged.expect_load_or_error(glb.substr(0, size));
    EXPECT_EQ(damaged.loaded, 0);
    damaged.expect_load_or_error(glb);
    EXPECT_EQ(damaged.loaded, 1);
}

TEST(Fuzz, FlippedBytesLoadOrAreRefused) {
    const std::string glb = small_glb();
    std::mt19937 random(1);
    Damaged damaged;
    for (int round = 0; round < 2000; ++round) {
        std::string bytes = glb;
        for (int flips = 1 + static_cast<int>(random() % 3); flips > 0; --flips) {
            bytes[random() % bytes.size()] = static_cast<char>(random());
        }
        damaged.expect_load_or_error(bytes);
    }
    EXPECT_GT(damaged.loaded, 100);
    EXPECT_GT(damaged.refused, 100);
}

TEST(Fuzz, FlippedBytesOfHairLoadOrAreRefused) {
    const std::string glb = hairy_glb();
    std::mt19937 random(1);
    Damaged damaged;
    for (int round = 0; round < 2000; ++round) {
        std::string bytes = glb;
        for (int flips = 1 + static_cast<int>(random() % 3); flips > 0; --flips) {
            bytes[random() % bytes.size()] = static_cast<char>(random());
        }
        damaged.expect_load_or_error(bytes);
    }
    EXPECT_GT(damaged.loaded, 100);
    EXPECT_GT(damaged.refused, 100);
}

TEST(Fuzz, ChangedDigitsLoadOrAreRefused) {
    // Numbers of the JSON text are where the damage is subtle.
    const std::string glb = small_glb();
    std::vector<std::size_t> digits;
    for (std::size_t i = 20; i < glb.find("BIN"); ++i) {
        if (glb[i] >= '0' && glb[i] <= '9') digits.push_back(i);
    }
    Damaged damaged;
    for (const std::size_t at : digits) {
        for (const char c : std::string("0123456789-.e ")) {
            std::string bytes = glb;
            bytes[at] = c;
            damaged.expect_load_or_error(bytes);
        }
    }
    EXPECT_GT(damaged.loaded, 50);
    EXPECT_GT(damaged.refused, 500);
}

RC_GTEST_PROP(Fuzz, ArbitraryBinaryChunksLoadOrAreRefused, (const std::vector<std::uint8_t>& bytes)) {
    std::string glb = small_glb();
    const std::size_t begin = glb.find("BIN") + 4;
    for (std::size_t i = 0; i < bytes.size() && begin + i < glb.size(); ++i)
        glb[begin + i] = static_cast<char>(bytes[i]);
    Damaged damaged;
    damaged.expect_load_or_error(glb);
    RC_ASSERT(damaged.loaded + damaged.refused == 1);
}

}  // namespace
}  // namespace tessera::test
