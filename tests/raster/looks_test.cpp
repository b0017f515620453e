// Views, models of reflection and metallic-roughness materials: what they show, and the same bits on every device.
#include "patches/mikktspace.hpp"
#include "raster/portable.hpp"
#include "raster/portable_rasteriser.hpp"
#include "support/devices.hpp"

#include <cmath>
#include <set>

namespace tessera::test {
namespace {

using Pixel = std::array<int, 4>;

Pixel pixel_at(const image::Image& picture, std::uint32_t x, std::uint32_t y) {
    const std::uint8_t* p = &picture.rgba[(std::size_t{y} * picture.width + x) * 4];
    return {p[0], p[1], p[2], p[3]};
}

int code_of(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    return static_cast<int>(std::lround(255.0 * (x <= 0.0031308 ? x * 12.92 : 1.055 * std::pow(x, 1 / 2.4) - 0.055)));
}

/// A square that fills a flat frame of 16 x 16 pixels, facing the viewer; u to the right and v down.
struct Square {
    render::Frame frame = flat_frame(16, 16, 1);
    std::vector<Vertex> vertices{place_vertex(frame, 0, 0), place_vertex(frame, 0, 4096),
                                 place_vertex(frame, 4096, 4096), place_vertex(frame, 4096, 0)};
    std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3};
    std::vector<VertexAttributes> attributes;  // none at first
    scene::Material material;
    std::vector<scene::SceneImage> images;

    Square() {
        vertices[1].uv[1] = vertices[2].uv[1] = vertices[2].uv[0] = vertices[3].uv[0] = 1.0f;
        for (Vertex& vertex : vertices)
            vertex.position[2] = -3.0f;
        frame.camera.projection[2][2] = -0.1f;  // depths of 0 to 10
        frame.camera.projection[3][2] = 0.0f;
        frame.shading = render::Shading::pbr;
        frame.sky = {glm::vec3(0.0f), glm::vec3(0.0f), glm::vec3(0.0f)};
    }

    /// An image of one colour.
    std::uint32_t add_image(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a = 255) {
        scene::SceneImage image;
        image.pixels = {4, 4, {}};
        for (int i = 0; i < 16; ++i)
            image.pixels.rgba.insert(image.pixels.rgba.end(), {r, g, b, a});
        images.push_back(std::move(image));
        return static_cast<std::uint32_t>(images.size() - 1);
    }

    void light_ahead(float intensity) {
        scene::Light light;
        light.intensity = glm::vec3(intensity);
        frame.lights = {light};
    }

    /// Tangents for the material's normal map.
    void add_tangents() {
        const std::vector<patches::PatchCorners> faces{{0, 1, 2, 3}};
        const auto tangents = patches::corner_tangents(vertices, faces, material.maps.normal->transform);
        attributes.resize(4);
        for (std::size_t i = 0; i < 4; ++i) {
            for (int k = 0; k < 4; ++k)
                attributes[i].tangent[k] = tangents[0][i][k];
        }
    }

    /// Draws on every device, expects the same bits, and returns the picture.
    image::Image draw() const {
        std::optional<image::Image> first;
        for (const gpu::Device& device : open_every_device()) {
            const auto rasteriser = raster::open_portable(device);
            rasteriser->begin(frame);
            rasteriser->set_materials({material}, images);
            rasteriser->draw(render::Draw{vertices, indices, 0, attributes});
            const image::Image picture = rasteriser->finish();
            if (!first) first = picture;
            EXPECT_EQ(picture.rgba, first->rgba) << device.info().id;
        }
        return *first;
    }
};

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

/// GGX and Lambert as glTF 2.0, appendix B, has them, in double precision, where all vectors are one.
double head_on(double base, double metallic, double roughness) {
    const double f0 = 0.04 + (base - 0.04) * metallic;
    const double a2 = std::pow(roughness, 4.0);
    const double lobe = 1.0 / (M_PI * a2) / 4.0;
    return f0 * lobe + (1.0 - f0) * base * (1.0 - metallic) / M_PI;
}

TEST(MetallicRoughness, IsThatOfTheSpecificationHeadOn) {
    for (const double metallic : {0.0, 0.4, 1.0}) {
        for (const double roughness : {0.6, 1.0}) {
            Square square;
            square.light_ahead(1.5f);
            square.material.base_color = glm::vec4(0.8f, 0.4f, 0.1f, 1.0f);
            square.material.metallic = static_cast<float>(metallic);
            square.material.roughness = static_cast<float>(roughness);
            const Pixel middle = pixel_at(square.draw(), 8, 8);
            const std::array<double, 3> base{0.8, 0.4, 0.1};
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_NEAR(middle[i], code_of(1.5 * head_on(base[i], metallic, roughness)), 1) << metallic;
        }
    }
}

TEST(MetallicRoughness, MultipliesFactorsByMaps) {
    Square square;
    square.light_ahead(1.5f);
    square.material.base_color = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f);
    square.material.metallic = 0.8f;
    square.material.roughness = 1.0f;
    square.material.base_color_image = square.add_image(255, 188, 0);  // 1, 0.503, 0
    square.material.maps.metallic_roughness = scene::Map{square.add_image(0, 204, 128)};
    const Pixel middle = pixel_at(square.draw(), 8, 8);
    EXPECT_NEAR(middle[0], code_of(1.5 * head_on(0.8, 0.8 * 128 / 255, 0.8)), 1);
    EXPECT_NEAR(middle[1], code_of(1.5 * head_on(0.8 * 0.5029, 0.8 * 128 / 255, 0.8)), 1);
    EXPECT_NEAR(middle[2], code_of(1.5 * head_on(0.0, 0.8 * 128 / 255, 0.8)), 1);
}

TEST(MetallicRoughness, OccludesTheSkyAndAddsEmission) {
    Square square;
    square.frame.sky = {glm::vec3(1.0f), glm::vec3(1.0f), glm::vec3(1.0f)};
    square.material.roughness = 1.0f;
    const Pixel open = pixel_at(square.draw(), 8, 8);
    EXPECT_GT(open[0], 240);  // white under a white sky, but for what the fit loses
    square.material.maps.occlusion = scene::Map{square.add_image(0, 255, 255)};
    EXPECT_EQ(pixel_at(square.draw(), 8, 8), (Pixel{0, 0, 0, 255}));
    square.material.emissive = glm::vec3(0.5f);
    square.material.maps.emissive = scene::Map{square.add_image(255, 188, 0)};
    EXPECT_EQ(pixel_at(square.draw(), 8, 8), (Pixel{code_of(0.5), code_of(0.5 * 0.5029), 0, 255}));
}

// Light from the upper right: a normal map that tilts towards it is brighter than one that tilts away, whichever way
// the coordinates are mirrored or turned.
TEST(MetallicRoughness, TiltsNormalsAlongTheCoordinates) {
    const auto brightness = [](glm::vec3 light, std::uint8_t r, std::uint8_t g, const glm::mat3& transform,
                               bool mirrored) {
        Square square;
        square.light_ahead(2.0f);
        square.frame.lights[0].direction = glm::normalize(light);
        square.material.roughness = 1.0f;
        if (mirrored) {
            for (Vertex& vertex : square.vertices)
                vertex.uv[0] = 1.0f - vertex.uv[0];
        }
        square.material.maps.normal =
            scene::Map{square.add_image(r, g, 220), scene::Wrap::repeat, scene::Wrap::repeat, transform};
        square.add_tangents();
        return pixel_at(square.draw(), 8, 8)[0];
    };
    const glm::mat3 same(1.0f);
    const glm::vec3 right(1, 0, 1), above(0, 1, 1);
    EXPECT_GT(brightness(right, 200, 128, same, false), brightness(right, 55, 128, same, false) + 20);
    EXPECT_GT(brightness(above, 128, 200, same, false), brightness(above, 128, 55, same, false) + 20);
    EXPECT_LT(brightness(right, 200, 128, same, true), brightness(right, 55, 128, same, true) - 20);
    EXPECT_GT(brightness(above, 128, 200, same, true), brightness(above, 128, 55, same, true) + 20);
    glm::mat3 turned(0.0f);  // the map's u grows with the vertices' v
    turned[1][0] = 1.0f;
    turned[0][1] = -1.0f;
    turned[2][2] = 1.0f;
    EXPECT_LT(brightness(above, 200, 128, turned, false), brightness(above, 55, 128, turned, false) - 20);
}

// The frame is the interpolated one, neither unit nor at right angles, as bakers decode: x t + y w (n x t) + z n.
TEST(MetallicRoughness, DecodesNormalMapsAsMikktspaceDoes) {
    std::set<int> shown;
    for (const float w : {1.0f, -1.0f}) {
        for (const bool behind : {false, true}) {
            Square square;
            square.material.roughness = 1.0f;
            square.material.double_sided = true;
            square.material.maps.normal = scene::Map{square.add_image(191, 150, 230)};
            if (behind)
                std::swap(square.indices[1], square.indices[2]), std::swap(square.indices[4], square.indices[5]);
            const glm::dvec3 n(0.2, -0.1, behind ? -0.8 : 0.8), t(0.7, 0.4, 0.1);
            for (Vertex& vertex : square.vertices) {
                for (int k = 0; k < 3; ++k)
                    vertex.normal[k] = static_cast<float>(n[k]);
            }
            VertexAttributes frame;
            for (int k = 0; k < 3; ++k)
                frame.tangent[k] = static_cast<float>(t[k]);
            frame.tangent[3] = w;
            square.attributes.assign(4, frame);
            const glm::dvec3 b = static_cast<double>(w) * glm::cross(n, t);
            glm::dvec3 expected = (2.0 * 191 / 255 - 1) * t + (2.0 * 150 / 255 - 1) * b + (2.0 * 230 / 255 - 1) * n;
            expected = glm::normalize(expected) * (behind ? -1.0 : 1.0);
            Square plain;  // whose normal is that
            plain.material = square.material;
            plain.material.maps.normal.reset();
            plain.indices = square.indices;
            for (Vertex& vertex : plain.vertices) {
                for (int k = 0; k < 3; ++k)
                    vertex.normal[k] = static_cast<float>(expected[k]) * (behind ? -1.0f : 1.0f);
            }
            for (const glm::vec3& direction : {glm::vec3(1, 0, 1), {-1, 0, 1}, {0, 1, 1}, {0, -1, 1}, {0, 0, 1}}) {
                scene::Light light;
                light.direction = glm::normalize(direction);
                square.frame.lights = plain.frame.lights = {light};
                const int wanted = pixel_at(plain.draw(), 8, 8)[1];
                EXPECT_NEAR(pixel_at(square.draw(), 8, 8)[1], wanted, 1) << w << behind << direction.x << direction.y;
                shown.insert(wanted);
            }
        }
    }
    EXPECT_GT(shown.size(), 10u);
}

TEST(MetallicRoughness, LeavesNormalsAloneWithoutTangents) {
    Square square;
    square.light_ahead(1.5f);
    square.material.roughness = 1.0f;
    const Pixel flat = pixel_at(square.draw(), 8, 8);
    square.material.maps.normal = scene::Map{square.add_image(255, 128, 128)};
    EXPECT_EQ(pixel_at(square.draw(), 8, 8), flat);
    square.add_tangents();
    EXPECT_NE(pixel_at(square.draw(), 8, 8), flat);
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

TEST(MetallicRoughness, WrapsAsTheMapSays) {
    Square square;
    square.material.unlit = true;
    const std::uint32_t image = square.add_image(0, 0, 0);
    for (std::size_t i = 0; i < 16; ++i)
        square.images[image].pixels.rgba[i * 4] = i % 4 < 2 ? 0 : 255;  // left half black, right half red
    square.material.base_color_image = image;
    for (Vertex& vertex : square.vertices)
        vertex.uv[0] += 1.0f;
    square.material.wrap_u = scene::Wrap::repeat;
    EXPECT_EQ(pixel_at(square.draw(), 3, 8)[0], 0);
    square.material.wrap_u = scene::Wrap::clamp;
    EXPECT_EQ(pixel_at(square.draw(), 3, 8)[0], 255);
    square.material.wrap_u = scene::Wrap::mirror;
    const image::Image mirrored = square.draw();
    EXPECT_EQ(pixel_at(mirrored, 3, 8)[0], 255);
    EXPECT_EQ(pixel_at(mirrored, 12, 8)[0], 0);
}

TEST(MetallicRoughness, LightsThatHaveAPlaceFadeWithTheSquareOfTheDistance) {
    Square square;
    square.material.roughness = 1.0f;
    scene::Light light;
    light.kind = scene::Light::Kind::point;
    light.place = {0, 0, 1};  // 4 from the square
    light.intensity = glm::vec3(16.0f);
    square.frame.lights = {light};
    EXPECT_NEAR(pixel_at(square.draw(), 8, 8)[0], code_of(head_on(1.0, 0.0, 1.0)), 2);
    square.frame.lights[0].range = 3.0f;
    EXPECT_EQ(pixel_at(square.draw(), 8, 8)[0], 0);
    square.frame.lights[0].range = 0.0f;
    square.frame.lights[0].kind = scene::Light::Kind::spot;
    square.frame.lights[0].direction = {0, 0, 1};  // away from it
    square.frame.lights[0].cone_scale = 4.0f;
    square.frame.lights[0].cone_offset = -3.0f;
    EXPECT_EQ(pixel_at(square.draw(), 8, 8)[0], 0);
    square.frame.lights[0].direction = {0, 0, -1};
    EXPECT_NEAR(pixel_at(square.draw(), 8, 8)[0], code_of(head_on(1.0, 0.0, 1.0)), 3);
}

TEST(ToneCurve, IsNarkowicz) {
    Square square;
    square.material.emissive = glm::vec3(2.0f, 0.5f, 0.02f);
    square.frame.tone_curve = render::ToneCurve::aces;
    square.frame.exposure = 0.5f;
    const auto aces = [](double x) { return code_of(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14)); };
    EXPECT_EQ(pixel_at(square.draw(), 8, 8), (Pixel{aces(1.0), aces(0.25), aces(0.01), 255}));
}

TEST(MetallicRoughness, MasksAndBlendsLikeTheOtherShadings) {
    Square square;
    square.material.unlit = true;
    square.material.base_color_image = square.add_image(255, 0, 0, 100);
    square.material.alpha_mode = scene::AlphaMode::mask;
    square.material.alpha_cutoff = 0.5f;
    EXPECT_EQ(pixel_at(square.draw(), 8, 8)[3], 0);
    square.material.alpha_cutoff = 0.3f;
    EXPECT_EQ(pixel_at(square.draw(), 8, 8), (Pixel{255, 0, 0, 255}));
    square.material.alpha_mode = scene::AlphaMode::blend;
    EXPECT_EQ(pixel_at(square.draw(), 8, 8)[3], 100);
}

}  // namespace
}  // namespace tessera::test
