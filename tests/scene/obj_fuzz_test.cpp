// Damaged OBJ text loads as something sound or is refused. Seeds are fixed, so a failure repeats.
#include "scene/obj_files.hpp"

#include <rapidcheck/gtest.h>
#include <random>

namespace tessera::test {
namespace {

/// Something of every statement.
const std::string sample =
    "mtllib m.mtl\no a\n" + mixed_cube +
    "vt 0.5 0.25\nvt 1 1\nvn 0 0 1\nvn 1e-3 -.5 1E2\ng x y\nusemtl k\ns 2\n"
    "f 1/1/1 2/2/2 3/1/-1 4\nf -1//1 -2//2 -3//1 \\\n-4 -5//2 -6\ns off\nf 1 2 3\nf 5/1 6/2 7/-1 8 9\n"
    "l 1 2\nt crease 2/1/0 0 1 2.5\nt corner 1/1/0 2 1\nt hole 1/0/0 3\nt interpolateboundary 1/0/0 1\n";

class DamagedText {
public:
    void expect_load_or_error(const std::string& text) {
        const auto path = folder_.write("model.obj", text).string();
        folder_.write("m.mtl", text);
        for (const auto mode : {scene::NgonMode::split, scene::NgonMode::fan}) {
            try {
                expect_sound(scene::load_scene(path, {.ngons = mode}));
                ++loaded;
            } catch (const Error& error) {
                ASSERT_EQ(error.kind(), ErrorKind::usage);
                ++refused;
            }
        }
    }
    int loaded = 0;
    int refused = 0;

private:
    TemporaryFolder folder_;
};

TEST(ObjFuzz, TruncatedTextLoadsOrIsRefused) {
    DamagedText damaged;
    for (std::size_t size = 0; size <= sample.size(); ++size)
        damaged.expect_load_or_error(sample.substr(0, size));
    EXPECT_GT(damaged.loaded, 500);
    EXPECT_GT(damaged.refused, 20);
}

TEST(ObjFuzz, FlippedBytesLoadOrAreRefused) {
    std::mt19937 random(1);
    DamagedText damaged;
    for (int round = 0; round < 800; ++round) {
        std::string text = sample;
        for (int flips = 1 + static_cast<int>(random() % 4); flips > 0; --flips)
            text[random() % text.size()] = static_cast<char>(random());
        damaged.expect_load_or_error(text);
    }
    EXPECT_GT(damaged.loaded, 100);
    EXPECT_GT(damaged.refused, 100);
}

TEST(ObjFuzz, ChangedCharactersLoadOrAreRefused) {
    DamagedText damaged;
    for (std::size_t at = 0; at < sample.size(); at += 3) {
        for (const char c : std::string("09-/ \n\\#")) {
            std::string text = sample;
            text[at] = c;
            damaged.expect_load_or_error(text);
        }
    }
    EXPECT_GT(damaged.loaded, 200);
    EXPECT_GT(damaged.refused, 200);
}

TEST(ObjFuzz, LinesOfTheFormatInAnyOrderLoadOrAreRefused) {
    std::vector<std::string> lines;
    std::size_t from = 0;
    for (std::size_t end; (end = sample.find('\n', from)) != std::string::npos; from = end + 1)
        lines.push_back(sample.substr(from, end + 1 - from));
    std::mt19937 random(2);
    DamagedText damaged;
    for (int round = 0; round < 500; ++round) {
        std::string text = mixed_cube + "vt 0 0\nvt 0 0\nvn 0 1 0\nvn 1 0 0\n";
        for (int i = 0; i < 30; ++i)
            text += lines[random() % lines.size()];
        damaged.expect_load_or_error(text);
    }
    EXPECT_GT(damaged.loaded, 100);
}

/// Random faces over few positions, which lie in few places: every kind of degeneracy.
RC_GTEST_PROP(ObjFuzz, RandomFacesLoad, ()) {
    std::string text;
    for (int i = 0; i < 8; ++i) {
        text += "v";
        for (int c = 0; c < 3; ++c)
            text.append(" ").append(std::to_string(*rc::gen::inRange(-2, 3)));
        text += "\n";
    }
    const auto faces = *rc::gen::container<std::vector<std::vector<int>>>(
        rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 9)));
    for (const auto& face : faces) {
        text += *rc::gen::element<std::string>("", "s off\n", "s 1\n", "s 2\n");
        text += "f";
        for (const int corner : face)
            text.append(" ").append(std::to_string(corner));
        text += "\n";
    }
    DamagedText damaged;
    damaged.expect_load_or_error(text);
    RC_ASSERT(damaged.loaded == 2);
}

}  // namespace
}  // namespace tessera::test
