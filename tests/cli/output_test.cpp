// Output that cannot be written: exit code 4, a sentence, and no half file.
#include "cli/run.hpp"

#include <gtest/gtest.h>

namespace tessera::test {
namespace {

class Writes : public testing::TestWithParam<std::string> {
protected:
    std::vector<std::string> call(const std::string& output) const {
        if (GetParam() == "svg" || GetParam() == "csv") {
            return {"pattern", "--factors", "5", "-o", output};
        }
        return {"tessellate", "shape:torus", "-o", output};
    }
};

TEST_P(Writes, AFolderThatIsMissing) {
    const Folder folder;
    const Result result = run(call(folder.file("missing/out." + GetParam())));
    EXPECT_EQ(result.code, 4) << result.errors;
    EXPECT_TRUE(is_one_sentence(result.errors)) << result.errors;
    EXPECT_TRUE(folder.names().empty());
}

TEST_P(Writes, OntoAFolder) {
    const Folder folder;
    const std::string name = "folder." + GetParam();
    std::filesystem::create_directory(folder.file(name));
    const Result result = run(call(folder.file(name)));
    EXPECT_EQ(result.code, 4) << result.errors;
    EXPECT_TRUE(is_one_sentence(result.errors)) << result.errors;
    EXPECT_EQ(folder.names(), std::vector<std::string>{name});
    EXPECT_TRUE(std::filesystem::is_empty(folder.file(name)));
}

TEST_P(Writes, OverAFile) {
    const Folder folder;
    const std::string out = folder.file("out." + GetParam());
    write_file(out, "what was there before");
    EXPECT_EQ(run(call(out)).code, 0);
    std::vector<std::string> expected{"out." + GetParam()};
    if (GetParam() == "obj") {
        expected.insert(expected.begin(), "out.mtl");
    }
    EXPECT_EQ(folder.names(), expected);
    EXPECT_NE(read_file(out), "what was there before");
}

// A run that fails keeps the file that was there.
TEST_P(Writes, NothingWhenTheJobFails) {
    const Folder folder;
    const std::string out = folder.file("out." + GetParam());
    write_file(out, "what was there before");
    std::vector<std::string> words = call(out);
    words.insert(words.end(), {"--device", "vulkan:voodoo"});
    EXPECT_EQ(run(words, no_devices()).code, 3);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"out." + GetParam()});
    EXPECT_EQ(read_file(out), "what was there before");
}

INSTANTIATE_TEST_SUITE_P(As, Writes, testing::Values("glb", "obj", "ply", "svg", "csv"),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace tessera::test
