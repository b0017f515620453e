// tessera pattern --check: all well gives 0; a wrong line is printed and gives 1.
#include "cli/run.hpp"
#include "support/environment.hpp"

#include <gtest/gtest.h>

namespace tessera::test {
namespace {

const std::string header = "domain,partitioning,topology,factor_bits,points,indices,points_fnv1a64,indices_fnv1a64\n";
const std::string good = "tri,int,cw,3f800000|3f800000|3f800000|3f800000,3,3,8e69b1e8fac963d5,756241e1be8c9396\n";
const std::string bad = "tri,int,cw,3f800000|3f800000|3f800000|3f800000,3,3,8e69b1e8fac963d5,756241e1be8c9397\n";

TEST(PatternCheck, GoodFile) {
    const Folder folder;
    write_file(folder.file("good.csv"), header + good);
    const Result result = run({"pattern", "--check", folder.file("good.csv")});
    EXPECT_EQ(result.code, 0);
    EXPECT_TRUE(result.output.ends_with("\n1 cases, 0 mismatches\n")) << result.output;
}

TEST(PatternCheck, ACorruptedLineIsPrinted) {
    const Folder folder;
    write_file(folder.file("bad.csv"), header + good + bad);
    const Result result = run({"pattern", "--check", folder.file("bad.csv")});
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(result.output.starts_with("reference: line 3: 3 points (expected 3), 3 indices (3)")) << result.output;
    EXPECT_NE(result.output.find("756241e1be8c9396 (756241e1be8c9397)"), std::string::npos) << result.output;
    EXPECT_TRUE(result.output.ends_with("\n2 cases, 1 mismatches\n")) << result.output;
}

TEST(PatternCheck, MalformedFile) {
    const Folder folder;
    write_file(folder.file("malformed.csv"), header + "tri,int\n");
    const Result result = run({"pattern", "--check", folder.file("malformed.csv")});
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(is_one_sentence(result.errors)) << result.errors;
}

TEST(PatternCheck, EveryDeviceAgreesWithTheSharedFile) {
    TESSERA_SHARED_OR_SKIP(shared);
    const Result result = run({"pattern", "--check", (shared / "golden/tessellator.csv").string(), "--device", "all"});
    EXPECT_EQ(result.code, 0) << result.output;
    EXPECT_TRUE(result.output.ends_with(" cases, 0 mismatches\n")) << result.output;
}

}  // namespace
}  // namespace tessera::test
