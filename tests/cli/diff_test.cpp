// tessera diff: verdicts, exit codes, heat map, JSON.
#include "cli/run.hpp"
#include "compare/pictures.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tessera::test {
namespace {

class Diff : public testing::Test {
protected:
    void SetUp() override {
        const image::Image picture = drawing(60, 40);
        image::write_png(picture, a);
        image::write_png(noisy(picture, 20), b);
        image::write_png(drawing(61, 40), wider);
        write_file(broken, "no picture");
    }

    const Folder folder;
    const std::string a = folder.file("a.png"), b = folder.file("b.png"), wider = folder.file("wider.png"),
                      broken = folder.file("broken.png"), map = folder.file("map.png");
};

TEST_F(Diff, EqualPicturesPass) {
    const Result result = run({"diff", a, a}, no_devices());
    EXPECT_EQ(result.code, 0) << result.errors;
    EXPECT_NE(result.output.find("equal, 60 x 40 pixels"), std::string::npos) << result.output;
    EXPECT_NE(result.output.find("\nPASS\n"), std::string::npos) << result.output;
}

TEST_F(Diff, DifferentOnesFailUnlessAGateAllowsThem) {
    EXPECT_EQ(run({"diff", a, b}).code, 1);
    EXPECT_NE(run({"diff", a, b}).output.find("\nFAIL\n"), std::string::npos);
    EXPECT_EQ(run({"diff", a, b, "--max-flip", "0.5"}).code, 0);
    EXPECT_EQ(run({"diff", a, b, "--max-flip", "0.0001"}).code, 1);
    EXPECT_EQ(run({"diff", a, b, "--tolerance", "20"}).code, 0);
    EXPECT_EQ(run({"diff", a, b, "--tolerance", "1"}).code, 1);
    EXPECT_EQ(run({"diff", a, b, "--tolerance", "1", "--max-outliers", "2400"}).code, 0);
    EXPECT_EQ(run({"diff", a, b, "--tolerance", "1", "--max-outliers", "2400", "--max-flip", "0"}).code, 1);
}

TEST_F(Diff, JsonHoldsEveryMeasure) {
    const Result result = run({"diff", a, b, "--json", "--tolerance", "3"});
    EXPECT_EQ(result.code, 1);
    const auto document = nlohmann::json::parse(result.output);
    EXPECT_EQ(document["pass"], false);
    EXPECT_EQ(document["failures"].size(), 1u);
    EXPECT_EQ(document["width"], 60);
    EXPECT_GT(document["psnr"].get<double>(), 20.0);
    EXPECT_LT(document["ssim"].get<double>(), 1.0);
    EXPECT_GT(document["flip"]["mean"].get<double>(), 0.0);
    EXPECT_GE(document["flip"]["percentile_99"].get<double>(), document["flip"]["mean"].get<double>());
    EXPECT_GE(document["over_tolerance"].get<int>(), document["outliers"].get<int>());
    const auto same = nlohmann::json::parse(run({"diff", a, a, "--json"}).output);
    EXPECT_TRUE(same["psnr"].is_null());
    EXPECT_EQ(same["pass"], true);
}

TEST_F(Diff, TheHeatMapIsWrittenWhateverTheVerdict) {
    const Result result = run({"diff", a, b, "-o", map});
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.errors.find(map), std::string::npos);
    EXPECT_EQ(run({"diff", map, map}).code, 0) << "the map is a picture";
    EXPECT_EQ(run({"diff", map, a}).code, 1) << "of the same size";
}

TEST_F(Diff, WhatCannotBeComparedIsAMatterOfUsage) {
    const std::vector<std::vector<std::string>> calls{
        {a, wider},       {a, broken}, {broken, a}, {a, folder.file("missing.png")}, {a, folder.path().string()},
        {a, "/dev/zero"},
    };
    for (const auto& files : calls) {
        const Result result = run({"diff", files[0], files[1], "-o", map});
        EXPECT_EQ(result.code, 2) << result.errors;
        EXPECT_TRUE(is_one_sentence(result.errors)) << result.errors;
        EXPECT_EQ(result.output, "");
    }
    EXPECT_EQ(run({"diff", a, wider}).errors, "tessera: Only pictures of the same size can be compared, but " + a +
                                                  " has 60 x 40 pixels and " + wider + " has 61 x 40.\n");
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"--max-flip", "2"},
                                                                                       {"--max-flip", "nan"},
                                                                                       {"--tolerance", "256"},
                                                                                       {"--tolerance", "-1"},
                                                                                       {"--max-outliers", "-1"},
                                                                                       {"--ppd", "0"}}) {
        EXPECT_EQ(run({"diff", a, b, words[0], words[1]}).code, 2) << words[0] << " " << words[1];
    }
    EXPECT_EQ(run({"diff", a}).code, 2);
    EXPECT_EQ(run({"diff", a, b, "-o", folder.file("missing/map.png")}).code, 4);
}

}  // namespace
}  // namespace tessera::test
