// The GLB container and plain text, told apart by content.
#include "scene/gltf_container.hpp"

#include "scene/gltf_builder.hpp"

namespace tessera::test {
namespace {

GltfBuilder triangle() {
    GltfBuilder builder;
    builder.add_mesh_node({{"attributes", {{"POSITION", builder.add_positions(triangle_positions)}}}});
    return builder;
}

/// `bytes` with the four at `at` replaced.
std::string patched(std::string bytes, std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i)
        bytes.at(at + i) = static_cast<char>((value >> (8 * i)) & 0xff);
    return bytes;
}

TEST(Container, ContentTellsBinaryFromTextWhateverTheName) {
    const TemporaryFolder folder;
    const GltfBuilder builder = triangle();
    EXPECT_EQ(scene::load_scene(folder.write("binary.gltf", builder.glb()).string()).meshes.size(), 1u);
    EXPECT_EQ(scene::load_scene(folder.write("text.glb", builder.text()).string()).meshes.size(), 1u);
    EXPECT_EQ(scene::load_scene(folder.write("LOUD.GLB", builder.glb()).string()).meshes.size(), 1u);
    EXPECT_EQ(scene::load_scene(folder.write("bom.gltf", "\xef\xbb\xbf" + builder.text()).string()).meshes.size(), 1u);
}

TEST(Container, EveryLengthIsCheckedAgainstTheBytes) {
    const TemporaryFolder folder;
    const std::string glb = triangle().glb();
    const auto size = static_cast<std::uint32_t>(glb.size());
    const auto refused = [&](const std::string& bytes) { return refusal(folder.write("model.glb", bytes).string()); };
    EXPECT_NE(refused(patched(glb, 4, 1)).find("version 1"), std::string::npos);
    EXPECT_NE(refused(patched(glb, 8, size + 4)).find("gives a length of"), std::string::npos);
    EXPECT_NE(refused(patched(glb, 8, 12)).find("gives a length of 12"), std::string::npos);
    EXPECT_NE(refused(patched(glb, 12, 0xffffffff)).find("chunk 0 gives a length of 4294967295"), std::string::npos);
    EXPECT_NE(refused(patched(glb, 16, 0x004e4942)).find("JSON must be the first chunk"), std::string::npos);
    EXPECT_NE(refused(patched(glb + "1234", 8, size + 4)).find("needs a header of 8 bytes"), std::string::npos);
    EXPECT_NE(refused(patched(glb.substr(0, 12), 8, 12)).find("no JSON"), std::string::npos);
    EXPECT_NE(refused("glTF").find("needs 12 bytes"), std::string::npos);
}

TEST(Container, NeitherKindIsRefused) {
    const TemporaryFolder folder;
    EXPECT_NE(refusal(folder.write("a.glb", "").string()).find("is empty"), std::string::npos);
    EXPECT_NE(refusal(folder.write("b.glb", "PNG").string()).find("neither"), std::string::npos);
    EXPECT_NE(refusal(folder.write("c.gltf", "[1]").string()).find("neither"), std::string::npos);
    EXPECT_NE(refusal((folder.path() / "absent.glb").string()).find("does not exist"), std::string::npos);
    std::filesystem::create_directory(folder.path() / "folder.glb");
    EXPECT_NE(refusal((folder.path() / "folder.glb").string()).find("not a regular file"), std::string::npos);
}

TEST(Container, OtherFormatsAreNamedWithWhatCanBeRead) {
    EXPECT_NE(refusal("model.fbx").find(".gltf, .glb and .obj"), std::string::npos);
    EXPECT_NE(refusal("model").find("shape:NAME"), std::string::npos);
}

}  // namespace
}  // namespace tessera::test
