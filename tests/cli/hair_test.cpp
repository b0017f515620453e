// Hair at the command line: files of guides alone, and of a surface with guides.
#include "cli/run.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tessera::test {
namespace {

const std::string furball = "assets/furball.glb";

/// Two straight guides and nothing else.
std::string guides_file(const Folder& folder) {
    const nlohmann::json document{
        {"asset", {{"version", "2.0"}}},
        {"nodes", {{{"mesh", 0}}}},
        {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"mode", 1}}}}}}},
        {"accessors", {{{"bufferView", 0}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}}}},
        {"bufferViews", {{{"buffer", 0}, {"byteLength", 48}}}},
        // (0,0,0) (0,2,0) (2,0,0) (2,2,0)
        {"buffers",
         {{{"byteLength", 48},
           {"uri",
            "data:application/octet-stream;base64,"
            "AAAAAAAAAAAAAAAAAAAAAAAAAEAAAAAAAAAAQAAAAAAAAAAAAAAAQAAAAEAAAAAA"}}}}};
    const std::string path = folder.file("guides.gltf");
    write_file(path, document.dump());
    return path;
}

TEST(HairCommands, TessellateWritesSurfaceAndRibbons) {
    const Folder folder;
    for (const char* extension : {"glb", "obj", "ply"}) {
        const std::string out = folder.file(std::string("out.") + extension);
        const Result result =
            run({"tessellate", furball, "-o", out, "--hairs", "3", "--hair-segments", "4", "--factor", "1", "--json"});
        ASSERT_EQ(result.code, 0) << result.errors;
        const auto document = nlohmann::json::parse(result.output);
        EXPECT_EQ(document["guides"], 440);
        const auto hair_patches = document["hair_patches"].get<std::uint64_t>();
        EXPECT_GT(hair_patches, 800u);
        EXPECT_EQ(document["triangles"], 336 + hair_patches * 3 * 4 * 2);
    }
    // What was written reads back; the ribbons are its largest part.
    const Result again = run({"verify", folder.file("out.glb"), "--device", "reference", "--factor", "1"});
    EXPECT_EQ(again.code, 0) << again.errors;
}

TEST(HairCommands, RibbonsStayTrianglesAmongQuads) {
    const Folder folder;
    const Result result =
        run({"tessellate", furball, "-o", folder.file("out.glb"), "--hairs", "2", "--topology", "quads"});
    EXPECT_EQ(result.code, 0) << result.errors;
}

TEST(HairCommands, TangentsAreRefused) {
    const Folder folder;
    const Result result = run({"tessellate", furball, "-o", folder.file("out.glb"), "--tangents", "uv"});
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.errors.find("tangents"), std::string::npos) << result.errors;
}

TEST(HairCommands, AFileOfGuidesAloneIsFine) {
    const Folder folder;
    const std::string guides = guides_file(folder);
    const Result written = run({"tessellate", guides, "-o", folder.file("out.ply"), "--hairs", "5", "--json"});
    ASSERT_EQ(written.code, 0) << written.errors;
    EXPECT_EQ(nlohmann::json::parse(written.output)["triangles"], 5 * 16 * 2);
    const Result facing =
        run({"tessellate", guides, "-o", folder.file("out.ply"), "--ribbons", "camera", "--eye", "1,1,9"});
    EXPECT_EQ(facing.code, 0) << facing.errors;
    const Result verified = run({"verify", guides, "--device", "reference", "--all", "--json"});
    ASSERT_EQ(verified.code, 0) << verified.errors;
    const auto jobs = nlohmann::json::parse(verified.output);
    EXPECT_EQ(jobs.size(), 8u) << "two kinds of ribbons, four partitionings";
    EXPECT_EQ(jobs[0]["ribbons"], "camera");
    EXPECT_GT(jobs[0]["devices"][0]["stages"]["vertices"]["words"], 0);
}

TEST(HairCommands, WrongWordsAreAMatterOfUsage) {
    const Folder folder;
    const std::string guides = guides_file(folder);
    const std::vector<std::vector<std::string>> ends{
        {"--hairs", "0"},        {"--hairs", "5000"},   {"--hair-segments", "65"},  {"--hair-width", "-1"},
        {"--hair-width", "nan"}, {"--hair-taper", "2"}, {"--hair-variation", "-1"}, {"--ribbons", "round"},
        {"--ribbons", "camera"},  // without an eye
        {"--eye", "1,2"}};
    for (const auto& end : ends) {
        std::vector<std::string> call{"tessellate", guides, "-o", folder.file("out.ply")};
        call.insert(call.end(), end.begin(), end.end());
        const Result result = run(call, no_devices());
        EXPECT_EQ(result.code, 2) << end[0] << " " << end[1] << "\n" << result.errors;
        EXPECT_NE(result.errors, "");
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"guides.gltf"});
}

}  // namespace
}  // namespace tessera::test
