// What is drawn where: coverage, culling, depth, shadings, and pictures that do not depend on how draws are cut.
#include <cmath>

#include "render/picture_suite.hpp"

namespace tessera::test {
namespace {

constexpr Pixel nothing{0, 0, 0, 0};
constexpr Pixel facing{128, 128, 255, 255};  // the normal (0, 0, 1) as a colour

class Drawing : public Picture {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Drawing);
INSTANTIATE_TEST_SUITE_P(By, Drawing, testing::ValuesIn(drawers()), drawer_name);

/// The lower left half of the image; the pixels of its diagonal are half covered.
DrawnMesh half_image() {
    DrawnMesh mesh = rectangle({-1, -1}, {1, 1}, 0);
    mesh.indices = {0, 1, 3};
    return mesh;
}

TEST_P(Drawing, CoversTheRightPixelsAndSmoothsEdges) {
    const image::Image picture = draw(half_image());
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            if (x < y) expect_pixel(picture, x, y, facing, 1);
            if (x > y) expect_pixel(picture, x, y, nothing, 0);
        }
        const int alpha = pixel_at(picture, y, y)[3];
        EXPECT_TRUE(alpha == 64 || alpha == 128 || alpha == 191) << alpha;
        expect_pixel(picture, y, y, {facing[0], facing[1], facing[2], alpha}, 1);
    }
}

TEST_P(Drawing, AveragesEdgesInLinearLight) {
    frame.background = {0, 0, 0, 1};
    scene::Material white;
    const DrawnMesh normal_up = rectangle({-1, -1}, {1, 1}, 0, {1, 1, 1});
    DrawnMesh mesh = normal_up;
    mesh.indices = {0, 1, 3};
    const image::Image picture = draw(mesh, white);
    const int inside = pixel_at(picture, 10, 50)[0];
    const double light = std::pow((inside / 255.0 + 0.055) / 1.055, 2.4);
    const int edge = pixel_at(picture, 30, 30)[0];
    EXPECT_TRUE(std::abs(edge - srgb(light * 0.5)) <= 1 || std::abs(edge - srgb(light * 0.25)) <= 1 ||
                std::abs(edge - srgb(light * 0.75)) <= 1)
        << edge << " beside " << inside;
}

TEST_P(Drawing, CullsBackFacesUnlessDoubleSided) {
    DrawnMesh mesh = rectangle({-1, -1}, {1, 1}, 0);
    std::swap(mesh.indices[1], mesh.indices[2]);
    const image::Image culled = draw(mesh);
    expect_pixel(culled, 40, 50, nothing, 0);
    expect_pixel(culled, 40, 20, facing, 1);  // the other triangle
    scene::Material material;
    material.double_sided = true;
    expect_pixel(draw(mesh, material), 40, 50, {128, 128, 0, 255}, 1);  // its normal turned around
}

TEST_P(Drawing, ShowsWhatIsNearerInEitherOrder) {
    const DrawnMesh near_right = rectangle({0, -1}, {1, 1}, 0.5f, {1, 0, 0});
    const DrawnMesh far_all = rectangle({-1, -1}, {1, 1}, -0.5f, {0, 1, 0});
    for (const bool near_first : {true, false}) {
        rasteriser->begin(frame);
        rasteriser->set_materials({{}}, {});
        for (const bool near_now : {near_first, !near_first}) {
            const DrawnMesh& mesh = near_now ? near_right : far_all;
            rasteriser->draw(mesh.vertices, mesh.indices, 0);
        }
        const image::Image picture = rasteriser->finish();
        expect_pixel(picture, 10, 30, {128, 255, 128, 255}, 1);
        expect_pixel(picture, 50, 30, {255, 128, 128, 255}, 1);
    }
}

TEST_P(Drawing, ShowsTheBackgroundWhereNothingIs) {
    frame.background = {1.0f, 0.0f, 0.25f, 0.5f};
    expect_pixel(draw({}), 3, 60, {255, 0, srgb(0.25), 128}, 2);
    frame.background.a = 1.0f;
    expect_pixel(draw({}), 60, 3, {255, 0, srgb(0.25), 255}, 1);
    EXPECT_EQ(render::Frame{}.background.a, 1.0f);
}

TEST_P(Drawing, PhongAddsAmbientDiffuseAndSpecular) {
    frame.shading = render::Shading::phong;
    scene::Material material;
    material.base_color = {0.8f, 0.1f, 0.0f, 1.0f};
    const glm::vec3 light = glm::normalize(glm::vec3(-0.5f, 0.7f, 1.0f));
    // The viewer is along +z of the pixel in the middle.
    const float z = -0.9f;
    const glm::vec3 halfway = glm::normalize(light + glm::vec3(0, 0, 1));
    struct Case {
        glm::vec3 normal;
        double lit, shine;
    };
    for (const Case& c :
         {Case{{0, 0, 1}, light.z, std::pow(halfway.z, 600.0)}, Case{halfway, glm::dot(halfway, light), 1},
          Case{-light, 0, 0}, Case{{0, 0, 0}, light.z, std::pow(halfway.z, 600.0)}}) {
        const image::Image picture = draw(rectangle({-1, -1}, {1, 1}, z, c.normal), material);
        const double body = 0.4 + 0.5 * c.lit;
        const double white = 0.3 * c.shine;
        expect_pixel(picture, 32, 32,
                     {srgb(std::min(0.8 * body + white, 1.0)), srgb(0.1 * body + white), srgb(white), 255}, 4);
    }
}

TEST_P(Drawing, WireframeShowsTheEdgesOfEachTriangle) {
    frame.shading = render::Shading::wireframe;
    const image::Image picture = draw(half_image());
    const auto is_edge = [&](std::uint32_t x, std::uint32_t y) { return pixel_at(picture, x, y)[0] < 128; };
    EXPECT_TRUE(is_edge(0, 40));   // left
    EXPECT_TRUE(is_edge(30, 63));  // bottom
    EXPECT_TRUE(is_edge(30, 30));  // diagonal
    for (std::uint32_t x = 3; x < 40; ++x)
        EXPECT_FALSE(is_edge(x, 44)) << x;
    // Both triangles of a rectangle: the diagonal from the bottom left to the top right.
    const image::Image both = draw(rectangle({-1, -1}, {1, 1}, 0));
    EXPECT_LT(pixel_at(both, 32, 31)[0], 128);
    EXPECT_GT(pixel_at(both, 32, 20)[0], 200);
}

TEST_P(Drawing, RepeatsBitForBit) {
    frame.camera = render::frame_bounds({glm::vec3(-1.0f), glm::vec3(1.0f)}, {}, 1.0f);
    for (const render::Shading shading :
         {render::Shading::phong, render::Shading::normals, render::Shading::wireframe}) {
        frame.shading = shading;
        const image::Image first = draw(sphere(40));
        EXPECT_EQ(first.rgba, draw(sphere(40)).rgba);
        frame.width = 100;
        draw(sphere(3));
        frame.width = 64;
        EXPECT_EQ(first.rgba, draw(sphere(40)).rgba);
    }
}

TEST_P(Drawing, OfAnySizeEqualsManySmallOnes) {
    const DrawnMesh whole = sphere(300);  // 360,000 triangles: three batches
    // The same triangles with their vertices far apart: no batch can upload its range.
    constexpr std::uint32_t apart = 8;
    DrawnMesh scattered{std::vector<Vertex>(whole.vertices.size() * apart), {}};
    for (std::size_t i = 0; i < whole.vertices.size(); ++i)
        scattered.vertices[i * apart] = whole.vertices[i];
    for (const std::uint32_t index : whole.indices)
        scattered.indices.push_back(index * apart);

    frame.camera = render::frame_bounds({glm::vec3(-1.0f), glm::vec3(1.0f)}, {}, 1.0f);
    frame.shading = render::Shading::phong;
    const image::Image at_once = draw(whole);
    EXPECT_GT(pixel_at(at_once, 32, 32)[3], 0);
    EXPECT_EQ(at_once.rgba, draw(scattered).rgba);

    rasteriser->begin(frame);
    rasteriser->set_materials({{}}, {});
    for (std::size_t first = 0; first < whole.indices.size(); first += 30000) {
        const std::size_t count = std::min<std::size_t>(30000, whole.indices.size() - first);
        rasteriser->draw(whole.vertices, std::span(whole.indices).subspan(first, count), 0);
    }
    EXPECT_EQ(at_once.rgba, rasteriser->finish().rgba);
}

TEST_P(Drawing, OfTinyAndHugeModelsIsTheSame) {
    const auto at_scale = [&](int exponent) {
        const float size = std::ldexp(1.0f, exponent);
        frame.camera = render::frame_bounds({glm::vec3(-size), glm::vec3(size)}, {}, 1.0f);
        frame.shading = render::Shading::phong;
        return draw(sphere(20, size)).rgba;
    };
    const std::vector<std::uint8_t> one = at_scale(0);
    EXPECT_EQ(one, at_scale(-99));
    EXPECT_EQ(one, at_scale(99));
}

TEST_P(Drawing, FillsTheWidestPictures) {
    frame.width = 8192;
    frame.height = 8;
    const image::Image picture = draw(rectangle({-1, -1}, {1, 1}, 0));
    ASSERT_EQ(picture.rgba.size(), std::size_t{8192} * 8 * 4);
    expect_pixel(picture, 0, 0, facing, 1);
    expect_pixel(picture, 8191, 7, facing, 1);
}

}  // namespace
}  // namespace tessera::test
