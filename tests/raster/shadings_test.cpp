// What shadings have besides their materials: views, the models of reflection, colours of vertices and the tone curve.
#include "raster/shaded_square.hpp"

#include <cmath>

namespace tessera::test {
namespace {

TEST(Views, ShowDepthFromWhiteToBlack) {
    Square square;
    square.frame.shading = render::Shading::depth;
    square.frame.depth_range = {2.0f, 4.0f};
    EXPECT_EQ(pixel_at(square.draw(), 8, 8), (Pixel{128, 128, 128, 255}));
    square.frame.depth_range = {3.0f, 4.0f};
    EXPECT_EQ(pixel_at(square.draw(), 8, 8), (Pixel{255, 255, 255, 255}));
}

TEST(Views, ShowTextureCoordinates) {
    Square square;
    square.frame.shading = render::Shading::uv;
    const image::Image picture = square.draw();
    EXPECT_EQ(pixel_at(picture, 0, 0), (Pixel{8, 8, 0, 255}));
    EXPECT_EQ(pixel_at(picture, 15, 4), (Pixel{247, 72, 0, 255}));
}

TEST(Views, ShowEdgesOverTheShading) {
    Square square;
    for (const auto shading : {render::Shading::phong, render::Shading::reflection, render::Shading::pbr}) {
        square.frame.shading = shading;
        square.frame.wires = false;
        const image::Image plain = square.draw();
        square.frame.wires = true;
        const image::Image wires = square.draw();
        EXPECT_EQ(pixel_at(wires, 12, 4), pixel_at(plain, 12, 4));
        EXPECT_NE(pixel_at(wires, 8, 8), pixel_at(plain, 8, 8));  // the diagonal
    }
}

// The middle of a plane under a light straight ahead: ambient + diffuse, and all of the highlight.
TEST(Reflection, OfALightAheadIsTheSumOfItsConstants) {
    for (const bool half_vector : {false, true}) {
        Square square;
        square.frame.shading = render::Shading::reflection;
        square.frame.reflection = {half_vector, 0.1f,      0.2f,  0.3f,
                                   150.0f,      {0, 0, 1}, false, glm::vec3(0.5f, 0.0f, 1.0f)};
        const Pixel middle = pixel_at(square.draw(), 8, 8);
        // Half a pixel beside the middle, the eye is 0.0295 rad away.
        const double angle = std::atan(std::hypot(0.0625, 0.0625) / 3.0);
        const double shine = 0.3 * std::pow(std::cos(half_vector ? angle / 2 : angle), 150.0);
        EXPECT_NEAR(middle[0], code_of(0.5 * 0.3 + shine), 1);
        EXPECT_NEAR(middle[1], code_of(shine), 1);
        EXPECT_NEAR(middle[2], code_of(0.3 + shine), 1);
    }
}

/// Red, green, blue and black corners.
void paint_corners(Square& square) {
    square.attributes.resize(4);
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            square.attributes[i].color[k] = i == k ? 1.0f : 0.0f;
    }
}

TEST(VertexColours, VaryLinearlyInEveryShadingWithColours) {
    for (const auto shading : {render::Shading::phong, render::Shading::reflection, render::Shading::pbr}) {
        Square square;
        paint_corners(square);
        square.frame.shading = shading;
        // All light, whatever the model: ambient, or none at all.
        square.frame.reflection = {true, 1.0f, 0.0f, 0.0f, 1.0f, {0, 0, 1}, false, {}};
        square.material.unlit = true;
        for (Vertex& vertex : square.vertices)
            vertex.normal[2] = shading == render::Shading::phong ? -1.0f : 1.0f;  // away from the light
        const double light = shading == render::Shading::phong ? 0.4 : 1.0;
        const image::Image picture = square.draw();
        // Corners lie at the upper left, lower left, lower right and upper right; the diagonal joins the first and
        // third.
        const auto expect = [&](std::uint32_t x, std::uint32_t y, double r, double g, double b) {
            const Pixel pixel = pixel_at(picture, x, y);
            EXPECT_NEAR(pixel[0], code_of(light * r), 1);
            EXPECT_NEAR(pixel[1], code_of(light * g), 1);
            EXPECT_NEAR(pixel[2], code_of(light * b), 1);
        };
        const double u = 2.5 / 16, v = 12.5 / 16;  // in the triangle of red, green and blue
        expect(2, 12, 1 - v, v - u, u);
        expect(12, 2, 1 - v, 0, u);  // red, blue and black, mirrored
    }
}

TEST(VertexColours, MultiplyFactorTextureAndAlpha) {
    for (const auto shading : {render::Shading::phong, render::Shading::reflection, render::Shading::pbr}) {
        Square square;
        square.frame.shading = shading;
        square.frame.reflection = {true, 1.0f, 0.0f, 0.0f, 1.0f, {0, 0, 1}, false, {}};
        square.material.unlit = true;
        square.material.base_color = {0.5f, 1.0f, 1.0f, 0.9f};
        square.material.base_color_image = square.add_image(255, 188, 255, 204);
        for (Vertex& vertex : square.vertices)
            vertex.normal[2] = shading == render::Shading::phong ? -1.0f : 1.0f;
        const double light = shading == render::Shading::phong ? 0.4 : 1.0;
        VertexAttributes colour;
        colour.color[0] = 0.5f;
        colour.color[1] = 0.8f;
        colour.color[3] = 0.5f;  // 0.9 x 0.8 x 0.5 = 0.36
        square.attributes.assign(4, colour);
        const Pixel expected{code_of(light * 0.25), code_of(light * 0.8 * 0.5029), code_of(light), 255};
        const Pixel opaque = pixel_at(square.draw(), 8, 8);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(opaque[i], expected[i], 1);
        square.material.alpha_mode = scene::AlphaMode::mask;
        square.material.alpha_cutoff = 0.37f;
        EXPECT_EQ(pixel_at(square.draw(), 8, 8)[3], 0);
        square.material.alpha_cutoff = 0.35f;
        EXPECT_EQ(pixel_at(square.draw(), 8, 8), opaque);
        square.material.alpha_mode = scene::AlphaMode::blend;
        EXPECT_NEAR(pixel_at(square.draw(), 8, 8)[3], 92, 1);
    }
}

TEST(VertexColours, ThatAreWhiteOrOutOfRangeChangeNothing) {
    for (const auto shading : {render::Shading::phong, render::Shading::reflection, render::Shading::pbr}) {
        Square square;
        square.frame.shading = shading;
        square.light_ahead(1.5f);
        square.material.base_color_image = square.add_image(200, 188, 17);
        const image::Image plain = square.draw();
        square.attributes.resize(4);
        EXPECT_EQ(square.draw().rgba, plain.rgba);
        for (float& c : square.attributes[1].color)
            c = 1e30f;
        square.attributes[2].color[0] = INFINITY;
        square.attributes[2].tangent[0] = NAN;
        square.attributes[3].tangent[1] = -INFINITY;
        EXPECT_EQ(square.draw().rgba, plain.rgba);
    }
}

TEST(ToneCurve, IsNarkowicz) {
    Square square;
    square.material.emissive = glm::vec3(2.0f, 0.5f, 0.02f);
    square.frame.tone_curve = render::ToneCurve::aces;
    square.frame.exposure = 0.5f;
    const auto aces = [](double x) { return code_of(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14)); };
    EXPECT_EQ(pixel_at(square.draw(), 8, 8), (Pixel{aces(1.0), aces(0.25), aces(0.01), 255}));
}

}  // namespace
}  // namespace tessera::test
