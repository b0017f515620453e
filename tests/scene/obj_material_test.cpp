// Material libraries of OBJ files and the textures they name.
#include "image/image.hpp"
#include "scene/obj_files.hpp"

namespace tessera::test {
namespace {

class ObjMaterials : public testing::Test {
protected:
    scene::Scene load(const std::string& library, const std::string& statements = "mtllib m.mtl\nusemtl red\n") {
        if (!library.empty()) folder_.write("m.mtl", library);
        auto scene = scene::load_scene(folder_.write("model.obj", statements + square + "f 1 2 3 4\n").string());
        expect_sound(scene);
        return scene;
    }

    void write_png(const std::string& name) {
        folder_.write(name, "");
        image::write_png({2, 1, {255, 0, 0, 255, 0, 255, 0, 255}}, (folder_.path() / name).string());
    }

    TemporaryFolder folder_;
};

TEST_F(ObjMaterials, ColourAndOpacityAreRead) {
    const auto scene = load("newmtl blue\nKd 0 0 1\nnewmtl red\nKd 1 0.25 0\nd 0.5\n");
    ASSERT_EQ(scene.materials.size(), 1u) << "only what is used";
    EXPECT_EQ(scene.materials[0].name, "red");
    EXPECT_EQ(scene.materials[0].base_color, glm::vec4(1.0f, 0.25f, 0.0f, 0.5f));
    EXPECT_EQ(scene.materials[0].alpha_mode, scene::AlphaMode::blend);
    EXPECT_TRUE(scene.materials[0].double_sided);
    EXPECT_TRUE(scene.messages.empty());
}

TEST_F(ObjMaterials, ATextureIsFoundFromTheLibrarysFolder) {
    write_png("maps/a b.png");
    folder_.write("maps/m.mtl", "newmtl red\nKd 1 1 1\nmap_Kd a b.png\n");
    const auto scene = load("", "mtllib maps/m.mtl\nusemtl red\n");
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.materials[0].base_color_image, 0u);
    EXPECT_EQ(scene.images[0].pixels.width, 2u);
    EXPECT_EQ(scene.images[0].mime_type, "image/png");
    EXPECT_EQ(scene.materials[0].alpha_mode, scene::AlphaMode::opaque);
}

TEST_F(ObjMaterials, BackslashesSeparateFolders) {
    write_png("maps/a.png");
    EXPECT_EQ(load("newmtl red\nKd 1 1 1\nmap_Kd maps\\a.png\n").images.size(), 1u);
}

TEST_F(ObjMaterials, AnImageIsLoadedOnce) {
    write_png("a.png");
    folder_.write("m.mtl", "newmtl red\nmap_Kd a.png\nnewmtl blue\nmap_Kd a.png\n");
    const auto scene = load("", "mtllib m.mtl\nusemtl blue\nv 0 0 1\nf -1 1 2\nusemtl red\n");
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.images.size(), 1u);
}

TEST_F(ObjMaterials, LibraryNamesMayHoldSpacesOrBeSeveral) {
    folder_.write("my mats.mtl", "newmtl red\nKd 1 0 0\n");
    EXPECT_TRUE(load("", "mtllib my mats.mtl\nusemtl red\n").messages.empty());
    folder_.write("a.mtl", "newmtl blue\nKd 0 0 1\n");
    EXPECT_TRUE(load("newmtl red\nKd 1 0 0\n", "mtllib a.mtl m.mtl\nusemtl red\n").messages.empty());
}

TEST_F(ObjMaterials, WhatIsMissingIsSaidAndDoneWithout) {
    EXPECT_TRUE(has_message(load("", "mtllib none.mtl\n"), "\"none.mtl\" does not exist"));
    const auto undefined = load("newmtl blue\nKd 0 0 1\n");
    EXPECT_TRUE(has_message(undefined, "\"red\" is not defined"));
    EXPECT_EQ(undefined.materials[0].base_color, glm::vec4(1.0f));
    EXPECT_TRUE(has_message(load("newmtl red\nKd 1 1 1\nmap_Kd none.png\n"), "\"none.png\" does not exist"));
    folder_.write("text.png", "not an image");
    EXPECT_TRUE(has_message(load("newmtl red\nKd 1 1 1\nmap_Kd text.png\n"), "neither PNG nor JPEG"));
}

TEST_F(ObjMaterials, NothingOutsideTheFolderIsRead) {
    EXPECT_TRUE(has_message(load("", "mtllib ../m.mtl\n"), "leaves the document's folder"));
    EXPECT_TRUE(has_message(load("", "mtllib /etc/hostname\n"), "absolute path"));
    EXPECT_TRUE(has_message(load("newmtl red\nmap_Kd ../a.png\n"), "leaves the document's folder"));
    EXPECT_TRUE(has_message(load("newmtl red\nmap_Kd /etc/hostname\n"), "absolute path"));
    EXPECT_TRUE(has_message(load("newmtl red\nmap_Kd C:\\a.png\n"), "not a relative path"));
}

TEST_F(ObjMaterials, UnsoundValuesAreClampedAndUnsoundLibrariesIgnored) {
    const auto scene = load("newmtl red\nKd 2 -1 0e999\nd 0e999\n");
    EXPECT_EQ(scene.materials[0].base_color.r, 1.0f);
    EXPECT_EQ(scene.materials[0].base_color.g, 0.0f);
    EXPECT_TRUE(has_message(scene, "Kd is 2: it is taken as 1"));
    EXPECT_TRUE(has_message(load(std::string("newmtl red\nKd 1\0 0\n", 19)), "zero byte"));
    load("Kd\nnewmtl\nmap_Kd\nd\nTr 0.5\nnewmtl red\nmap_Kd -s\nmap_Kd -bm\nillum\nmap_Kd -imfchan\n");
}

}  // namespace
}  // namespace tessera::test
