// tessera bench, as CI runs it: that it works and what it writes, not how fast anything is.
#include "cli/run.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tessera::test {
namespace {

TEST(Bench, AQuickRunWritesEveryForm) {
    const Folder folder;
    const Result result = run({"bench", "--quick", "--json", folder.file("a.json"), "--markdown", folder.file("a.md"),
                               "--plot", folder.file("a.svg"), "--repetitions", "2"});
    ASSERT_EQ(result.code, 0) << result.errors << result.output;
    const auto json = nlohmann::json::parse(read_file(folder.file("a.json")));
    EXPECT_EQ(json["quick"], true);
    ASSERT_GE(json["marks"].size(), 10u);
    for (const auto& mark : json["marks"]) {
        for (const char* name : {"name", "value", "unit", "mark", "met"}) {
            EXPECT_TRUE(mark.contains(name)) << mark;
        }
    }
    bool reference = false;
    for (const auto& figure : json["figures"]) {
        reference = reference || (figure["workload"] == "W1" && figure["contestant"] == "reference");
        EXPECT_GT(figure["seconds"]["median"].get<double>(), 0.0) << figure;
    }
    EXPECT_TRUE(reference);
    EXPECT_NE(read_file(folder.file("a.md")).find("## Marks"), std::string::npos);
    EXPECT_NE(read_file(folder.file("a.svg")).find("</svg>"), std::string::npos);
    EXPECT_NE(result.output.find("Marks"), std::string::npos);
}

TEST(Bench, MeasuresWhatWasAskedFor) {
    const Folder folder;
    const Result result =
        run({"bench", "--quick", "--workload", "W6", "--device", "reference", "--json", folder.file("a.json")});
    ASSERT_EQ(result.code, 0) << result.errors;
    const auto json = nlohmann::json::parse(read_file(folder.file("a.json")));
    EXPECT_TRUE(json["figures"].empty());
    ASSERT_EQ(json["tables"].size(), 1u);
    EXPECT_EQ(json["tables"][0]["id"], "W6");
    EXPECT_EQ(json["tables"][0]["rows"].size(), 1u);
}

TEST(Bench, WrongWordsAreAMatterOfUsage) {
    const std::vector<std::vector<std::string>> calls{{"bench", "--workload", "W8"},
                                                      {"bench", "--repetitions", "0"},
                                                      {"bench", "--quick", "--plot", "bars.pdf"},
                                                      {"bench", "--quick", "--remarks", "/nonexistent.md"}};
    for (const auto& call : calls) {
        const Result result = run(call);
        EXPECT_EQ(result.code, 2) << call.back() << ": " << result.output;
        EXPECT_NE(result.errors, "");
    }
}

}  // namespace
}  // namespace tessera::test
