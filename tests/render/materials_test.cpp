// Base colour, textures and alpha.
#include "render/picture_suite.hpp"

namespace tessera::test {
namespace {

class Materials : public Picture {
protected:
    void SetUp() override {
        Picture::SetUp();
        frame.shading = render::Shading::phong;
    }
    /// What a surface that faces away from the light shows of its colour: the ambient share.
    static constexpr double ambient = 0.4;
    const glm::vec3 unlit{0.5f, -0.7f, -1.0f};
};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Materials);
INSTANTIATE_TEST_SUITE_P(By, Materials, testing::ValuesIn(drawers()), drawer_name);

/// An image of four quarters: red, green; blue, white.
scene::SceneImage quarters(std::uint32_t side) {
    scene::SceneImage image{"quarters", "image/png", {}, {side, side, {}}};
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const bool right = x >= side / 2;
            const bool low = y >= side / 2;
            const auto full = [](bool on) { return static_cast<std::uint8_t>(on ? 255 : 0); };
            image.pixels.rgba.insert(image.pixels.rgba.end(), {full(low == right), full(right), full(low), 255});
        }
    }
    return image;
}

TEST_P(Materials, TextureStandsUprightAndRepeats) {
    scene::Material material;
    material.base_color_image = 0;
    const int lit = srgb(ambient);
    // Once: the image's top left is the rectangle's top left. Twice: the same in each quarter of the picture.
    for (const std::uint32_t repeats : {1u, 2u}) {
        const image::Image picture =
            draw(rectangle({-1, -1}, {1, 1}, 0, unlit, static_cast<float>(repeats)), material, {quarters(64)});
        const std::uint32_t half = 32 / repeats;
        for (std::uint32_t corner = 0; corner < repeats; ++corner) {
            const std::uint32_t at = corner * 2 * half + half / 2;
            expect_pixel(picture, at, at, {lit, 0, 0, 255}, 1);
            expect_pixel(picture, at + half, at, {0, lit, 0, 255}, 1);
            expect_pixel(picture, at, at + half, {0, 0, lit, 255}, 1);
            expect_pixel(picture, at + half, at + half, {lit, lit, lit, 255}, 1);
        }
    }
}

TEST_P(Materials, TextureTooFineToSeeShowsItsMean) {
    scene::Material material;
    material.base_color_image = 0;
    const image::Image picture = draw(rectangle({-1, -1}, {1, 1}, 0, unlit, 640.0f), material, {quarters(512)});
    const int half_light = srgb(ambient * 0.5);  // every channel is full in two quarters of four
    expect_pixel(picture, 11, 17, {half_light, half_light, half_light, 255}, 2);
    expect_pixel(picture, 40, 50, {half_light, half_light, half_light, 255}, 2);
}

TEST_P(Materials, FactorMultipliesTextureAndEachDrawHasItsOwn) {
    scene::Material plain;
    plain.base_color = {0.25f, 0.5f, 1.0f, 1.0f};
    scene::Material textured = plain;
    textured.base_color_image = 1;
    const DrawnMesh left = rectangle({-1, -1}, {0, 1}, 0, unlit);
    const DrawnMesh right = rectangle({0, -1}, {1, 1}, 0, unlit);
    rasteriser->begin(frame);
    rasteriser->set_materials({plain, textured}, {scene::SceneImage{}, quarters(8)});
    rasteriser->draw(left.vertices, left.indices, 0);
    rasteriser->draw(right.vertices, right.indices, 1);
    const image::Image picture = rasteriser->finish();
    expect_pixel(picture, 16, 16, {srgb(ambient * 0.25), srgb(ambient * 0.5), srgb(ambient), 255}, 1);
    expect_pixel(picture, 38, 8, {srgb(ambient * 0.25), 0, 0, 255}, 1);
    expect_pixel(picture, 58, 8, {0, srgb(ambient * 0.5), 0, 255}, 1);
}

TEST_P(Materials, ColoursOfVerticesMultiplyAndVaryLinearly) {
    scene::Material material;
    material.base_color = {0.5f, 1.0f, 1.0f, 1.0f};
    const DrawnMesh mesh = rectangle({-1, -1}, {1, 1}, 0, unlit);
    std::vector<VertexAttributes> colours(mesh.vertices.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const float right = mesh.vertices[i].position[0] * 0.5f + 0.5f;
        colours[i].color[1] = right;
        colours[i].color[2] = 1.0f - right;
    }
    rasteriser->begin(frame);
    rasteriser->set_materials({material}, {});
    rasteriser->draw(render::Draw{mesh.vertices, mesh.indices, 0, colours});
    image::Image picture = rasteriser->finish();
    for (const std::uint32_t x : {0u, 20u, 50u}) {
        const double right = (x + 0.5) / 64;
        expect_pixel(picture, x, 30, {srgb(ambient * 0.5), srgb(ambient * right), srgb(ambient * (1 - right)), 255}, 1);
    }
    // Alpha too, and a draw without colours behind one with them is white again.
    for (VertexAttributes& c : colours)
        c.color[3] = 0.25f;
    material.alpha_mode = scene::AlphaMode::mask;
    rasteriser->begin(frame);
    rasteriser->set_materials({material}, {});
    rasteriser->draw(render::Draw{mesh.vertices, mesh.indices, 0, colours});
    expect_pixel(rasteriser->finish(), 20, 20, {0, 0, 0, 0}, 0);
    expect_pixel(draw(mesh, material), 20, 20, {srgb(ambient * 0.5), srgb(ambient), srgb(ambient), 255}, 1);
}

TEST_P(Materials, MaskDropsPixelsBelowTheCutoff) {
    scene::Material material;
    material.alpha_mode = scene::AlphaMode::mask;
    const DrawnMesh mesh = rectangle({-1, -1}, {1, 1}, 0, unlit);
    material.base_color.a = 0.49f;
    expect_pixel(draw(mesh, material), 20, 20, {0, 0, 0, 0}, 0);
    material.base_color.a = 0.51f;
    expect_pixel(draw(mesh, material), 20, 20, {srgb(ambient), srgb(ambient), srgb(ambient), 255}, 1);
}

TEST_P(Materials, OpaqueIgnoresAlpha) {
    scene::Material material;
    material.base_color.a = 0.1f;
    EXPECT_EQ(pixel_at(draw(rectangle({-1, -1}, {1, 1}, 0, unlit), material), 20, 20)[3], 255);
}

TEST_P(Materials, BlendShowsWhatLiesBehindInLinearLight) {
    scene::Material red;
    red.base_color = {1, 0, 0, 1};
    scene::Material glass;
    glass.base_color = {0, 0, 1, 0.5f};
    glass.alpha_mode = scene::AlphaMode::blend;
    const DrawnMesh left = rectangle({-1, -1}, {0, 1}, -0.5f, unlit);
    const DrawnMesh pane = rectangle({-1, -1}, {1, 1}, 0, unlit);
    rasteriser->begin(frame);
    rasteriser->set_materials({red, glass}, {});
    rasteriser->draw(left.vertices, left.indices, 0);
    rasteriser->draw(pane.vertices, pane.indices, 1);
    const image::Image picture = rasteriser->finish();
    const int half = srgb(ambient * 0.5);
    expect_pixel(picture, 16, 30, {half, 0, half, 255}, 2);
    expect_pixel(picture, 48, 30, {0, 0, srgb(ambient), 128}, 2);
}

}  // namespace
}  // namespace tessera::test
