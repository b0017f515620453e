// What render writes: cameras, turntables, animations, schemes side by side. Needs a device that draws.
#include "cli/run.hpp"
#include "image/image.hpp"
#include "support/environment.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <span>

namespace tessera::test {
namespace {

bool something_draws() {
    const auto document = nlohmann::json::parse(run({"devices", "--json"}).output);
    for (const auto& device : document["devices"]) {
        if (device["rasteriser"].get<bool>()) return true;
    }
    return false;
}

/// A square of 2 x 2 units that faces +z, seen by three cameras: one from +z, one from -z that sees its back (culled),
/// and an orthographic one that sees the middle quarter.
std::string square_with_cameras() {
    return R"({"asset": {"version": "2.0"},
        "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64,)"
           // Four positions, then 0 1 2 0 2 3 as shorts.
           "AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAACAPwAAgD8AAAAAAACAvwAAgD8AAAAAAAABAAIAAAACAAMA"
           R"("}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.9272952180016122, "znear": 0.1}},
                    {"type": "orthographic", "orthographic": {"xmag": 0.5, "ymag": 0.5, "znear": 0, "zfar": 9}}],
        "nodes": [{"mesh": 0},
                  {"name": "front", "camera": 0, "translation": [0, 0, 4]},
                  {"name": "back", "camera": 0, "translation": [0, 0, -4], "rotation": [0, 1, 0, 0]},
                  {"name": "middle", "camera": 1, "translation": [0, 0, 4]}]})";
}

class Pictures : public testing::Test {
protected:
    void SetUp() override {
        if (something_draws()) return;
        if (everything_required()) FAIL() << "no device draws";
        GTEST_SKIP() << "no device draws: pictures are not tested";
    }

    /// Renders with small sizes; returns the picture, empty where that failed.
    image::Image render(const std::string& model, std::vector<std::string> words) {
        const std::string out = folder.file("picture.png");
        words.insert(words.begin(), {"render", model, "-o", out, "--size", "64x64", "--factor", "2", "-q"});
        const Result result = run(words);
        EXPECT_EQ(result.code, 0) << result.errors;
        return result.code == 0 ? read("picture.png") : image::Image{};
    }

    image::Image read(const std::string& name) const {
        const std::string bytes = read_file(folder.file(name));
        return image::decode(std::as_bytes(std::span(bytes)), name);
    }

    /// The share of pixels that are not transparent.
    static double covered(const image::Image& picture) {
        double sum = 0.0;
        for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
            sum += picture.rgba[i] / 255.0;
        return sum * 4.0 / static_cast<double>(picture.rgba.size());
    }

    const Folder folder;
};

TEST_F(Pictures, CamerasOfTheFileByNameAndIndex) {
    const std::string model = folder.file("square.gltf");
    write_file(model, square_with_cameras());
    // Half the angle has the tangent 1/2: at 4 units the image is 4 high, and the square takes a quarter of it.
    const image::Image front = render(model, {"--camera", "front", "--transparent"});
    EXPECT_NEAR(covered(front), 0.25, 0.01);
    EXPECT_EQ(render(model, {"--camera", "0", "--transparent"}).rgba, front.rgba);
    EXPECT_EQ(covered(render(model, {"--camera", "back", "--transparent"})), 0.0);
    EXPECT_EQ(covered(render(model, {"--camera", "2", "--transparent"})), 1.0);
    EXPECT_EQ(render(model, {"--camera", "eye=0,0,4,fovy=53.13010235", "--transparent"}).rgba, front.rgba);
    EXPECT_EQ(render(model, {"--camera", "eye=0,0,4,fovy=0.92729522rad", "--transparent"}).rgba, front.rgba);
    EXPECT_NEAR(covered(render(model, {"--camera", "eye=0,0,3,target=0,0,0,up=1,0,0,ortho=8", "--transparent"})),
                1.0 / 16.0, 0.005);
    const Result unknown = run({"render", model, "-o", folder.file("x.png"), "--camera", "top"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_NE(unknown.errors.find("0 \"front\", 1 \"back\", 2 \"middle\""), std::string::npos) << unknown.errors;
}

TEST_F(Pictures, OrbitsAndTheirProjection) {
    const image::Image usual = render("shape:cube", {"--orbit", "30,20"});
    EXPECT_EQ(render("shape:cube", {"--camera", "30,20"}).rgba, usual.rgba) << "numbers alone are an orbit";
    EXPECT_EQ(render("shape:cube", {"--orbit", "390,20,1"}).rgba, usual.rgba);
    EXPECT_NE(render("shape:cube", {"--orbit", "30,20,1.5"}).rgba, usual.rgba);
    const image::Image front =
        render("shape:cube", {"--orbit", "0,0", "--projection", "orthographic", "--transparent"});
    EXPECT_NEAR(covered(front), 0.92 * 0.92, 0.03);
}

TEST_F(Pictures, TurntablesWriteASequence) {
    const auto write = [&](const std::string& name, const std::string& frames) {
        const Result result = run({"render", "shape:cube", "-o", folder.file(name), "--size", "32x32", "--factor", "1",
                                   "--turntable", frames});
        EXPECT_EQ(result.code, 0) << result.errors;
    };
    write("turn.png", "3");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"turn-000.png", "turn-001.png", "turn-002.png"}));
    EXPECT_NE(read("turn-000.png").rgba, read("turn-001.png").rgba);
    write("turn%02d.png", "1");
    write("%d%%.png", "2");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"0%.png", "1%.png", "turn-000.png", "turn-001.png",
                                                        "turn-002.png", "turn00.png"}));
    EXPECT_EQ(read("0%.png").rgba, read("turn-000.png").rgba) << "the first frame does not depend on how many follow";
}

TEST_F(Pictures, AnimationsAreOneFile) {
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"-o", folder.file("a.apng")}, {"-o", folder.file("b.png"), "--apng"}}) {
        std::vector<std::string> call{"render", "shape:torus", "--size", "32x24", "--turntable", "3", "--fps", "10"};
        call.insert(call.end(), words.begin(), words.end());
        EXPECT_EQ(run(call).code, 0);
    }
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.apng", "b.png"}));
    EXPECT_EQ(read("a.apng").width, 32u);
    const std::string bytes = read_file(folder.file("a.apng"));
    EXPECT_NE(bytes.find("acTL"), std::string::npos);
    EXPECT_NE(bytes.find("fdAT"), std::string::npos);
    EXPECT_EQ(bytes, read_file(folder.file("b.png")));
}

TEST_F(Pictures, SchemesStandSideBySide) {
    const image::Image both = render("shape:icosahedron", {"--compare", "linear,pn"});
    ASSERT_EQ(both.width, 128u);
    EXPECT_GT(both.height, 64u);
    // Under one camera: what is flat lies within what is round.
    const image::Image clear = render("shape:icosahedron", {"--compare", "linear,pn", "--transparent"});
    for (std::size_t y = 0; y < 64; ++y) {
        for (std::size_t x = 0; x < 64; ++x) {
            if (clear.rgba[(y * 128 + x) * 4 + 3] == 255) {
                ASSERT_EQ(clear.rgba[(y * 128 + 64 + x) * 4 + 3], 255) << x << ", " << y;
            }
        }
    }
    EXPECT_EQ(render("shape:icosahedron", {"--compare", "pn"}).rgba, render("shape:icosahedron", {}).rgba);
}

TEST_F(Pictures, ThatCannotBeWrittenEndWithFour) {
    for (const char* name : {"missing/out.png", "missing/out.apng"}) {
        const Result result =
            run({"render", "shape:cube", "-o", folder.file(name), "--size", "16x16", "--turntable", "2"});
        EXPECT_EQ(result.code, 4) << result.errors;
        EXPECT_TRUE(is_one_sentence(result.errors)) << result.errors;
    }
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace tessera::test
