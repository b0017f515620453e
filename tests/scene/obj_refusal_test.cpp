// OBJ text that makes no sense is refused with file, line and reason.
#include "scene/limits.hpp"
#include "scene/obj_files.hpp"

#include <fmt/format.h>

namespace tessera::test {
namespace {

struct Case {
    const char* name;
    std::string text;
    const char* reason;
};

const std::vector<Case> cases{
    {"Empty", "", "no vertices"},
    {"OnlyFaces", "f 1 2 3\n", "no vertices"},
    {"IndexZero", square + "f 1 2 0\n", "line 5: \"f\" names one of the positions by 0"},
    {"IndexTooLarge", square + "\nf 1 2 5\n", "line 6: \"f\" names one of the positions by 5, but there are only 4"},
    {"RelativeTooFar", square + "f -5 2 3\n", "line 5: \"f\" names one of the positions by -5, but only 4 come before"},
    {"RelativeToLaterVertices", "f -1 -2 -3\n" + square, "only 0 come before"},
    {"HugeIndex", square + "f 1 2 99999999999\n", "not a whole number"},
    {"LeastInt", square + "f 1 2 -2147483648\n", "only 4 come before"},
    {"UvIndexZero", square + "f 1/0 2 3\n", "texture coordinates by 0"},
    {"UvOutOfRange", square + "vt 0 0\nf 1/1 2/1 3/2\n", "texture coordinates by 2, but there are only 1"},
    {"NormalOutOfRange", square + "f 1//1 2//1 3//1\n", "normals by 1, but there are only 0"},
    {"NormalRelative", square + "vn 0 0 1\nf 1//-2 2//-1 3//-1\n", "normals by -2"},
    {"IndexIsText", square + "f a b c\n", "not a whole number"},
    {"IndexIsReal", square + "f 1.5 2 3\n", "not a whole number"},
    {"IndexMissing", square + "f /1 2 3\n", "not a whole number"},
    {"FourIndices", square + "vt 0 0\nvn 0 0 1\nf 1/1/1/1 2 3\n", "more than three indices"},
    {"TwoCoordinates", "v 1 2\n", "line 1: \"v\" has only 2 of the 3 numbers"},
    {"TwoCoordinatesOfNormal", "v 1 2 3\nvn 1 2\n", "line 2: \"vn\" has only 2"},
    {"NoTextureCoordinate", "v 1 2 3\nvt\n", "line 2: \"vt\" has only 0"},
    {"ZeroByte", square + std::string("f 1 2 3 \0 4\n", 12), "line 5"},
    {"ZeroByteInAName", square + std::string("g a\0b\nf 1 2 3\n", 14), "zero byte"},
};

class ObjRefusal : public testing::TestWithParam<Case> {};

TEST_P(ObjRefusal, NamesFileLineAndReason) {
    const std::string sentence = obj_refusal(GetParam().text);
    EXPECT_NE(sentence.find("model.obj: "), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(GetParam().reason), std::string::npos) << sentence;
    EXPECT_EQ(sentence.back(), '.') << sentence;
}

INSTANTIATE_TEST_SUITE_P(Texts, ObjRefusal, testing::ValuesIn(cases), [](const auto& info) { return info.param.name; });

TEST(ObjLimits, FacesHaveALargestNumberOfCorners) {
    const auto face = [](std::size_t corners) {
        std::string text, indices = "f";
        for (std::size_t i = 0; i < corners; ++i) {
            const auto x = static_cast<double>(i) / static_cast<double>(corners);
            text += fmt::format("v {} {} 0\n", x, x * x);
            indices.append(" ").append(std::to_string(i + 1));
        }
        return text + indices + "\n";
    };
    const auto scene = load_obj_text(face(scene::max_face_corners), scene::NgonMode::fan);
    EXPECT_EQ(scene.meshes.at(0).triangles.size(), 3 * (scene::max_face_corners - 2));
    const std::string sentence = obj_refusal(face(scene::max_face_corners + 1));
    EXPECT_NE(sentence.find("4097 corners, more than the 4096 supported"), std::string::npos) << sentence;
}

TEST(ObjRefusal, AMissingFileIsSaid) {
    const TemporaryFolder folder;
    EXPECT_NE(refusal((folder.path() / "none.obj").string()).find("does not exist"), std::string::npos);
}

}  // namespace
}  // namespace tessera::test
