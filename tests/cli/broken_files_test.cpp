// Every broken file of the shared data, through the program: one sentence and exit code 2, or a load that says what it
// left out; never a crash.
#include "cli/run.hpp"
#include "support/environment.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace tessera::test {
namespace {

struct Row {
    std::string file;
    bool may_load = false;
};

std::vector<Row> broken_rows(const std::filesystem::path& manifest) {
    std::ifstream in(manifest);
    std::vector<Row> rows;
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        inside = line.starts_with("## ") ? line.starts_with("## Broken") : inside;
        if (inside && line.starts_with("| `")) {
            const std::string file = line.substr(3, line.find('`', 3) - 3);
            rows.push_back({file, line.find("must fail") == std::string::npos});
        }
    }
    return rows;
}

TEST(BrokenFiles, GiveOneSentence) {
    TESSERA_SHARED_OR_SKIP(shared);
    const std::vector<Row> rows = broken_rows(shared / "models/MANIFEST.md");
    EXPECT_GE(rows.size(), 30u) << "the MANIFEST was not understood";
    const Folder folder;
    for (const Row& row : rows) {
        const std::string path = (shared / "broken" / row.file).string();
        const Result result = run({"tessellate", path, "-o", folder.file("out.glb"), "--factor", "2"}, no_devices());
        SCOPED_TRACE(row.file + ": " + result.errors);
        EXPECT_EQ(result.output, "");
        if (result.code == 0) {
            EXPECT_TRUE(row.may_load);
            continue;
        }
        EXPECT_EQ(result.code, 2);
        // The last line is the reason; messages about what was skipped may come before it.
        const std::size_t last = result.errors.rfind('\n', result.errors.size() - 2);
        EXPECT_TRUE(is_one_sentence(last == std::string::npos ? result.errors : result.errors.substr(last + 1)));
        EXPECT_TRUE(row.may_load || last == std::string::npos);
        EXPECT_NE(result.errors.find(path), std::string::npos);
    }
}

}  // namespace
}  // namespace tessera::test
