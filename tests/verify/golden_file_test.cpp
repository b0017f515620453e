// Golden files: what is read, what is refused, and that a wrong expectation is found.
#include "base/error.hpp"
#include "support/devices.hpp"
#include "verify/golden.hpp"

#include <bit>
#include <fstream>

#include <unistd.h>

namespace tessera::verify {
namespace {

const std::string header = "domain,partitioning,topology,factor_bits,points,indices,points_fnv1a64,indices_fnv1a64\n";
const std::string one = "tri,int,cw,3f800000|3f800000|3f800000|3f800000,3,3,8e69b1e8fac963d5,756241e1be8c9396";

/// A golden file that goes away with the test.
class GoldenFile {
public:
    explicit GoldenFile(const std::string& text)
        : path_(std::filesystem::temp_directory_path() / ("tessera-golden-" + std::to_string(getpid()) + ".csv")) {
        std::ofstream(path_) << text;
    }
    ~GoldenFile() { std::filesystem::remove(path_); }
    GoldenFile(const GoldenFile&) = delete;
    GoldenFile& operator=(const GoldenFile&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

TEST(GoldenFiles, ACaseIsRead) {
    const GoldenFile file(header + one +
                          "\r\n\nquad,odd,ccw,40400000|1|2|3|4|7fc00000,12,18,ff,0\niso,even,line,1|2,3,4,5,6\n");
    const std::vector<GoldenCase> cases = read_golden_file(file.path());
    ASSERT_EQ(cases.size(), 3u);
    EXPECT_EQ(cases[0].line, 2u);
    EXPECT_EQ(cases[0].domain, Domain::triangle);
    EXPECT_EQ(cases[0].partitioning, Partitioning::integer);
    EXPECT_TRUE(cases[0].clockwise);
    EXPECT_EQ(cases[0].factors[3], 1.0f);
    EXPECT_EQ(cases[0].point_count, 3u);
    EXPECT_EQ(cases[0].point_hash, 0x8e69b1e8fac963d5ull);
    EXPECT_EQ(cases[1].line, 4u);
    EXPECT_EQ(cases[1].domain, Domain::quad);
    EXPECT_EQ(cases[1].partitioning, Partitioning::fractional_odd);
    EXPECT_FALSE(cases[1].clockwise);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(cases[1].factors[5]), 0x7fc00000u);
    EXPECT_EQ(cases[2].domain, Domain::isoline);
    EXPECT_EQ(cases[2].index_hash, 6u);
}

TEST(GoldenFiles, MalformedLinesAreRefusedWithLineAndReason) {
    const struct {
        std::string line, reason;
    } bad[] = {
        {"tri,int,cw", "it has 3 fields instead of 8"},
        {one + ",7", "it has 9 fields instead of 8"},
        {"hex,int,cw,1|1|1|1,3,3,0,0", "field 1 is \"hex\""},
        {"tri,odder,cw,1|1|1|1,3,3,0,0", "field 2 is \"odder\""},
        {"tri,int,clockwise,1|1|1|1,3,3,0,0", "field 3 is \"clockwise\""},
        {"tri,int,cw,1|1|1,3,3,0,0", "it has 3 factors instead of 4"},
        {"quad,int,cw,1|1|1|1,3,3,0,0", "it has 4 factors instead of 6"},
        {"iso,int,line,1|1|1,3,3,0,0", "it has 3 factors instead of 2"},
        {"tri,int,cw,1|1|1|,3,3,0,0", "\"\" is not a number of base 16"},
        {"tri,int,cw,1|1|1|100000000,3,3,0,0", "\"100000000\" is not a number of base 16"},
        {"tri,int,cw,1|1|1|-1,3,3,0,0", "\"-1\" is not a number of base 16"},
        {"tri,int,cw,1|1|1|1,x,3,0,0", "\"x\" is not a number of base 10"},
        {"tri,int,cw,1|1|1|1,3,3 ,0,0", "\"3 \" is not a number of base 10"},
        {"tri,int,cw,1|1|1|1,3,3,0,11112222333344445", "\"11112222333344445\" is not a number of base 16"},
    };
    for (const auto& [line, reason] : bad) {
        const GoldenFile file(header + one + "\n" + line + "\n");
        try {
            read_golden_file(file.path());
            ADD_FAILURE() << "accepted " << line;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
            const std::string expected = file.path().string() + ", line 3 is not a golden case: " + reason + ".";
            EXPECT_EQ(std::string(error.what()), expected);
        }
    }
}

TEST(GoldenFiles, FilesWithoutCasesAreRefused) {
    EXPECT_THROW(read_golden_file("/nonexistent/golden.csv"), Error);
    EXPECT_THROW(read_golden_file("/"), Error);
    EXPECT_THROW(read_golden_file(GoldenFile("").path()), Error);
    EXPECT_THROW(read_golden_file(GoldenFile(header).path()), Error);
    // Without its header a file would lose its first case unseen.
    EXPECT_THROW(read_golden_file(GoldenFile(one + "\n" + one + "\n").path()), Error);
}

TEST(GoldenFiles, HashIsThatOfTheFormat) {
    EXPECT_EQ(fnv1a64({}), 0xcbf29ce484222325ull);
    // The single triangle of tessellator.csv's first case.
    const std::uint32_t points[] = {0, 65536, 0, 0, 65536, 0};
    const std::uint32_t indices[] = {0, 1, 2};
    EXPECT_EQ(fnv1a64(points), 0x8e69b1e8fac963d5ull);
    EXPECT_EQ(fnv1a64(indices), 0x756241e1be8c9396ull);
}

TEST(GoldenCases, AWrongExpectationIsFound) {
    std::vector<GoldenCase> cases = read_golden_file(GoldenFile(header + one + "\n" + one + "\n").path());
    EXPECT_TRUE(check_golden_cases(test::open_device("reference"), cases).empty());
    for (std::uint64_t GoldenCase::*field :
         {&GoldenCase::point_count, &GoldenCase::index_count, &GoldenCase::point_hash, &GoldenCase::index_hash}) {
        std::vector<GoldenCase> wrong = cases;
        wrong[1].*field ^= 1;
        const std::vector<GoldenMismatch> mismatches = check_golden_cases(test::open_device("reference"), wrong);
        ASSERT_EQ(mismatches.size(), 1u);
        EXPECT_EQ(mismatches[0].expected.line, 3u);
        EXPECT_EQ(mismatches[0].point_count, 3u);
        EXPECT_TRUE(describe(mismatches[0]).starts_with("line 3: 3 points")) << describe(mismatches[0]);
    }
}

}  // namespace
}  // namespace tessera::verify
