// Data in place and files beside the document, and none elsewhere.
#include "scene/uri.hpp"

#include "scene/gltf_builder.hpp"

namespace tessera::test {
namespace {

std::string decoded(std::string_view uri) {
    const auto bytes = scene::decode_data_uri(uri);
    if (!bytes) return "nothing";
    return {reinterpret_cast<const char*>(bytes->data()), bytes->size()};
}

TEST(Uri, Base64OfEveryLengthComesBack) {
    std::string bytes;
    for (int i = 0; i < 256; ++i) {
        EXPECT_EQ(decoded("data:any/type;base64," + base64(bytes)), bytes);
        bytes += static_cast<char>(i * 7);
    }
    EXPECT_EQ(decoded("data:;base64,QQ"), "A") << "padding may be absent";
}

TEST(Uri, WhatIsNotBase64IsNotDecoded) {
    for (const char* uri : {"data:text/plain,plain", "data:;base64", "data:;base64,A", "data:;base64,AA=A",
                            "data:;base64,AA A", "data:;base64,====", "file;base64,AAAA", "data:base64,AAAA"}) {
        EXPECT_EQ(decoded(uri), "nothing") << uri;
    }
}

TEST(Uri, PathsAreDecodedInsideTheFolder) {
    const auto resolved = [](const char* uri) { return scene::resolve_uri(uri, "/models").path.string(); };
    EXPECT_EQ(resolved("a.bin"), "/models/a.bin");
    EXPECT_EQ(resolved("textures/my%20file%25.png"), "/models/textures/my file%.png");
    EXPECT_EQ(resolved("a/../b.bin"), "/models/b.bin");
    EXPECT_EQ(resolved("..b.bin"), "/models/..b.bin");
}

TEST(Uri, PathsThatLeaveTheFolderAreRefused) {
    for (const char* uri :
         {"", "/etc/passwd", "../a.bin", "a/../../b.bin", "%2e%2e/a.bin", "%2Fetc/passwd", "..", "http://host/a.bin",
          "file:///a.bin", "c:\\a.bin", "..\\a.bin", "a%00.bin", "a%2", "a%zz"}) {
        EXPECT_TRUE(scene::resolve_uri(uri, "/models").problem.has_value()) << uri;
    }
}

TEST(Uri, BuffersComeFromFilesBesideTheDocument) {
    const TemporaryFolder folder;
    GltfBuilder builder;
    builder.add_mesh_node({{"attributes", {{"POSITION", builder.add_positions(triangle_positions)}}}});
    const auto with_buffer = [&](const std::string& uri, std::size_t length) {
        builder.document["buffers"] = {{{"uri", uri}, {"byteLength", length}}};
        return folder.write("scenes/model.gltf", builder.text()).string();
    };
    folder.write("scenes/the data.bin", builder.binary + "more");
    folder.write("secret.bin", builder.binary);
    EXPECT_EQ(scene::load_scene(with_buffer("the%20data.bin", 36)).meshes.size(), 1u) << "a file may be longer";
    EXPECT_NE(refusal(with_buffer("the%20data.bin", 41)).find("buffers[0].byteLength is 41, but there are only 40"),
              std::string::npos);
    EXPECT_NE(refusal(with_buffer("../secret.bin", 36)).find("leaves the document's folder"), std::string::npos);
    EXPECT_NE(refusal(with_buffer("absent.bin", 36)).find("\"absent.bin\" does not exist"), std::string::npos);
    EXPECT_NE(refusal(with_buffer("data:;base64,!!!!", 36)).find("not well-formed base64"), std::string::npos);
    EXPECT_NE(refusal(with_buffer("the%20data.bin", 2'000'000'000)).find("byteLength"), std::string::npos);
}

}  // namespace
}  // namespace tessera::test
