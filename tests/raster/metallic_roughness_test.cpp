// Metallic-roughness materials: the model of the glTF specification, its maps and its lights.
#include "raster/shaded_square.hpp"

#include <cmath>
#include <set>

namespace tessera::test {
namespace {

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
