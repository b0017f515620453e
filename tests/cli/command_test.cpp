// What every command answers: help, version, results, and the exit codes of wrong calls.
#include "cli/run.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tessera::test {
namespace {

TEST(Program, TellsItsVersion) {
    const Result result = run({"--version"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.output, "tessera " TESSERA_VERSION "\n");
}

TEST(Program, HelpNamesEveryCommandAndExitCode) {
    const Result result = run({"--help"});
    EXPECT_EQ(result.code, 0);
    for (const char* word : {"render", "tessellate", "verify", "diff", "pattern", "bench", "devices", "Exit codes"}) {
        EXPECT_NE(result.output.find(word), std::string::npos) << word;
    }
}

class Command : public testing::TestWithParam<const char*> {};

TEST_P(Command, HelpHasAnExample) {
    const Result result = run({GetParam(), "--help"});
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.output.find(std::string("tessera ") + GetParam() + " "), std::string::npos) << result.output;
    EXPECT_NE(result.output.find("Example"), std::string::npos);
}

TEST_P(Command, UnknownOptionsAreAMatterOfUsage) {
    const Result result = run({GetParam(), "--no-such-option"});
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.errors, "");
}

INSTANTIATE_TEST_SUITE_P(Of, Command,
                         testing::Values("render", "tessellate", "verify", "diff", "pattern", "bench", "devices"),
                         [](const auto& info) { return std::string(info.param); });

TEST(Program, WrongCallsAreAMatterOfUsage) {
    const Folder folder;
    const std::string out = folder.file("out.glb");
    const std::vector<std::vector<std::string>> calls{
        {},
        {"no-such-command"},
        {"tessellate"},
        {"tessellate", "shape:torus"},
        {"tessellate", "/nonexistent.glb", "-o", out},
        {"tessellate", "shape:dodecahedron", "-o", out},
        {"tessellate", "shape:torus", "-o", folder.file("out.stl")},
        {"tessellate", "shape:torus", "-o", out, "--scheme", "gregory"},
        {"tessellate", "shape:torus", "-o", out, "--normals", "cubic"},
        {"tessellate", "shape:torus", "-o", out, "--partitioning", "odd"},
        {"tessellate", "shape:torus", "-o", out, "--factor", "two"},
        {"tessellate", "shape:torus", "-o", out, "--factor", "1,2,3"},
        {"tessellate", "shape:torus", "-o", out, "--factor", "random:9..1"},
        {"tessellate", "shape:torus", "-o", out, "--alpha", "1.5"},
        {"tessellate", "shape:torus", "-o", out, "--memory-budget", "1K"},
        {"tessellate", "shape:torus", "-o", out, "--device", "quantum"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--size", "10"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--size", "0x10"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--shading", "gouraud"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--view", "sideways"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--tonemap", "filmic"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--shading", "pbr", "--preset", "van-veen"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--shading", "pbr", "--raster", "device"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--camera", "1,2,0"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--camera", "0"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--camera", "Front"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--camera", "target=0,0,0"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--camera", "eye=0,0"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--camera", "eye=0,0,nan"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--camera", "eye=0,0,5,eye=0,0,5"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--camera", "eye=0,0,5,fovy=180"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--camera", "eye=0,0,5,fovy=40,ortho=2"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--camera", "eye=0,0,5,ortho=0"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--camera", "eye=0,0,5,lens=35"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--camera", "eye=0,0,5", "--orbit", "0,0"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--camera", "eye=0,0,5", "--projection",
         "orthographic"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--orbit", "10"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--orbit", "10,20,1,175"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--orbit", "inf,20"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--projection", "fisheye"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--turntable", "0"},
        {"render", "shape:torus", "-o", folder.file("out%s.png"), "--turntable", "3"},
        {"render", "shape:torus", "-o", folder.file("out%d-%d.png"), "--turntable", "3"},
        {"render", "shape:torus", "-o", folder.file("out%.png"), "--turntable", "3"},
        {"render", "shape:torus", "-o", folder.file("out.png"), "--compare", "linear,gregory"},
        {"render", "shape:torus", "-o", folder.file("out.apng"), "--turntable", "3", "--fps", "0"},
        {"pattern"},
        {"pattern", "--factors", "1,2,3"},
        {"pattern", "--factors", "3", "--winding", "left"},
        {"pattern", "--factors", "3", "--check", "x.csv"},
        {"pattern", "--check", "/nonexistent.csv"},
        {"pattern", "--factors", "3", "-o", folder.file("out.txt")},
        {"verify"},
        {"verify", "shape:torus", "--device", "quantum"},
    };
    for (const auto& call : calls) {
        const Result result = run(call, no_devices());
        std::string words;
        for (const std::string& word : call)
            words += " " + word;
        EXPECT_EQ(result.code, 2) << words << "\n" << result.errors;
        EXPECT_NE(result.errors, "") << words;
        EXPECT_EQ(result.output, "") << words;
    }
    EXPECT_TRUE(folder.names().empty());
}

TEST(Devices, ListTheReference) {
    const Result result = run({"devices"});
    EXPECT_EQ(result.code, 0);
    EXPECT_TRUE(result.output.starts_with("reference\n")) << result.output;
}

TEST(Devices, JsonParses) {
    const Result result = run({"devices", "--json"});
    ASSERT_EQ(result.code, 0);
    const auto document = nlohmann::json::parse(result.output);
    ASSERT_FALSE(document["devices"].empty());
    const auto& reference = document["devices"][0];
    EXPECT_EQ(reference["id"], "reference");
    EXPECT_GE(reference["limits"]["max_storage_binding_size"].get<std::uint64_t>(), 128u << 20);
    for (const auto& device : document["devices"]) {
        for (const char* key :
             {"backend", "name", "driver", "version", "tessellation_stage", "rasteriser", "float_controls"}) {
            EXPECT_TRUE(device.contains(key)) << key;
        }
    }
}

TEST(Devices, SayWhyOthersAreNotUsable) {
    const Result result = run({"devices", "--json"}, no_devices());
    ASSERT_EQ(result.code, 0);
    const auto document = nlohmann::json::parse(result.output);
    EXPECT_EQ(document["devices"].size(), 1u);
    for (const auto& device : document["unusable"]) {
        EXPECT_TRUE(device["reason"].get<std::string>().ends_with('.')) << device;
    }
    EXPECT_GE(document["unusable"].size(), 2u);
}

TEST(Tessellate, JsonParsesAndTellsTheCounts) {
    const Folder folder;
    const Result result = run({"tessellate", "shape:icosahedron", "-o", folder.file("out.ply"), "--factor", "3",
                               "--partitioning", "uniform", "--json"});
    ASSERT_EQ(result.code, 0) << result.errors;
    const auto document = nlohmann::json::parse(result.output);
    EXPECT_EQ(document["patches"], 20);
    EXPECT_EQ(document["triangles"], 180);
    EXPECT_EQ(document["vertices"], 200);
    EXPECT_EQ(document["stage_milliseconds"].size(), 6u);
    EXPECT_NE(result.errors.find("180 triangles"), std::string::npos);
}

TEST(Tessellate, QuietSaysNothing) {
    const Folder folder;
    for (const char* extension : {"glb", "obj", "ply"}) {
        const Result result =
            run({"tessellate", "shape:cube", "-q", "-o", folder.file(std::string("out.") + extension)});
        EXPECT_EQ(result.code, 0);
        EXPECT_EQ(result.output + result.errors, "");
    }
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"out.glb", "out.mtl", "out.obj", "out.ply"}));
}

TEST(Verify, TheReferenceAgreesWithItself) {
    const Result result = run({"verify", "shape:torus", "--device", "reference", "--factor", "random:1..5"});
    EXPECT_EQ(result.code, 0) << result.errors;
    EXPECT_NE(result.output.find("same bits"), std::string::npos) << result.output;
    const Result json = run({"verify", "shape:torus", "--device", "reference", "--json"});
    ASSERT_EQ(json.code, 0);
    const auto document = nlohmann::json::parse(json.output);
    EXPECT_EQ(document[0]["devices"][0]["stages"]["vertices"]["differing"], 0);
}

TEST(Pattern, CsvOnStandardOutput) {
    const Result result = run({"pattern", "--factors", "1", "--partitioning", "integer"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.output,
              "element,index,a,b,c\npoint,0,0,65536,\npoint,1,0,0,\npoint,2,65536,0,\ntriangle,0,0,1,2\n");
}

}  // namespace
}  // namespace tessera::test
