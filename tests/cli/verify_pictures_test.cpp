// verify --pictures: what it compares and what it says.
#include "cli/run.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tessera::test {
namespace {

TEST(VerifyPictures, ComparesEveryDevice) {
    const Result result =
        run({"verify", "shape:icosahedron", "--pictures", "--pixels", "50", "--factor", "2", "--json"});
    ASSERT_EQ(result.code, 0) << result.errors;
    const auto found = nlohmann::json::parse(result.output);
    ASSERT_EQ(found.size(), 1u);
    const auto devices = nlohmann::json::parse(run({"devices", "--json"}).output)["devices"];
    ASSERT_EQ(found[0]["devices"].size(), devices.size());
    std::size_t drawing = 0;
    for (std::size_t d = 0; d < devices.size(); ++d) {
        EXPECT_EQ(found[0]["devices"][d]["id"], devices[d]["id"]);
        EXPECT_EQ(found[0]["devices"][d]["pixels"], 2 * 50 * 50);
        EXPECT_EQ(found[0]["devices"][d]["differing"], 0);
        drawing += devices[d]["rasteriser"].get<bool>() ? 1 : 0;
    }
    ASSERT_EQ(found[0]["rasterisers"].size(), drawing);
    for (const auto& rasteriser : found[0]["rasterisers"]) {
        EXPECT_LT(rasteriser["flip"], 0.02);
        EXPECT_EQ(rasteriser["pixels"], 50 * 50);
    }
}

TEST(VerifyPictures, OfAllSchemesAreFour) {
    const Result result = run({"verify", "shape:cube", "--pictures", "--pixels", "20", "--all"}, no_devices());
    EXPECT_EQ(result.code, 0) << result.errors;
    EXPECT_NE(result.output.find("4 jobs on 1 devices, 0 with differences"), std::string::npos) << result.output;
}

TEST(VerifyPictures, RefusesWhatMakesNoSense) {
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"--pixels", "20"}, {"--pictures", "--pixels", "0"}, {"--pictures", "--markdown"}}) {
        std::vector<std::string> all{"verify", "shape:cube"};
        all.insert(all.end(), words.begin(), words.end());
        EXPECT_EQ(run(all, no_devices()).code, 2) << words.back();
    }
}

}  // namespace
}  // namespace tessera::test
