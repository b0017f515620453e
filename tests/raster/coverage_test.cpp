// Every sample of a surface is covered exactly once, however it is cut into triangles.
#include "raster/portable.hpp"
#include "scene/scene.hpp"
#include "support/devices.hpp"
#include "tessellate/tessellate.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

namespace tessera::test {
namespace {

class Coverage : public testing::TestWithParam<gpu::DeviceInfo> {
protected:
    gpu::Device device = open_device(GetParam().id);
    std::mt19937 random{7};

    int between(int low, int high) { return std::uniform_int_distribution(low, high)(random); }
};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Coverage);
TESSERA_ON_EVERY_DEVICE(Coverage);

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// A grid of random inner vertices over the whole frame and `beyond` pixels outside it; each cell is cut along a random
/// diagonal. Folds are avoided: a vertex moves by less than half a cell, rounded to sub-pixels.
template <typename Random>
Mesh random_grid(const render::Frame& frame, int cells, int beyond, Random&& between) {
    Mesh mesh;
    const int width = static_cast<int>(frame.width + 2 * static_cast<std::uint32_t>(beyond)) * 256;
    const int height = static_cast<int>(frame.height + 2 * static_cast<std::uint32_t>(beyond)) * 256;
    for (int y = 0; y <= cells; ++y) {
        for (int x = 0; x <= cells; ++x) {
            const bool inside = x > 0 && y > 0 && x < cells && y < cells;
            const int reach_x = inside ? width / cells / 5 : 0;
            const int reach_y = inside ? height / cells / 5 : 0;
            mesh.vertices.push_back(place_vertex(frame, width * x / cells - beyond * 256 + between(-reach_x, reach_x),
                                                 height * y / cells - beyond * 256 + between(-reach_y, reach_y)));
        }
    }
    const auto row = static_cast<std::uint32_t>(cells + 1);
    for (std::uint32_t y = 0; y + 1 < row; ++y) {
        for (std::uint32_t x = 0; x + 1 < row; ++x) {
            const std::uint32_t a = y * row + x;
            if (between(0, 1) == 0) {
                mesh.indices.insert(mesh.indices.end(), {a, a + row, a + 1, a + 1, a + row, a + row + 1});
            } else {
                mesh.indices.insert(mesh.indices.end(), {a, a + row, a + row + 1, a, a + row + 1, a + 1});
            }
        }
    }
    return mesh;
}

void expect_once(const std::vector<int>& counts) {
    const auto wrong = std::ranges::find_if(counts, [](int count) { return count != 1; });
    EXPECT_TRUE(wrong == counts.end()) << "sample " << wrong - counts.begin() << " of " << counts.size()
                                       << " is covered " << *wrong << " times";
}

TEST_P(Coverage, CountsLayers) {
    const render::Frame frame = flat_frame(8, 8, 1);
    Mesh mesh{{place_vertex(frame, 0, 0), place_vertex(frame, 0, 2048), place_vertex(frame, 2048, 2048),
               place_vertex(frame, 2048, 0)},
              {}};
    for (int layers = 0; layers <= 4; ++layers) {
        EXPECT_EQ(coverage_counts(device, frame, mesh.vertices, mesh.indices), std::vector<int>(64, layers));
        mesh.indices.insert(mesh.indices.end(), {0, 1, 2, 0, 2, 3});
    }
}

// Cells from far larger than the picture's tiles to smaller than a pixel.
TEST_P(Coverage, OfRandomGridsIsOnce) {
    for (const int cells : {1, 2, 7, 40, 150}) {
        for (const int beyond : {0, 3, 5000}) {
            SCOPED_TRACE(testing::Message() << cells << " cells, " << beyond << " pixels beyond");
            const render::Frame frame = flat_frame(100, 83, 1);
            const Mesh mesh = random_grid(frame, cells, beyond, [&](int a, int b) { return between(a, b); });
            expect_once(coverage_counts(device, frame, mesh.vertices, mesh.indices));
        }
    }
}

TEST_P(Coverage, OfFourSamplesLeavesNoGap) {
    for (const int cells : {1, 7, 150}) {
        const render::Frame frame = flat_frame(70, 90, 4);
        const Mesh mesh = random_grid(frame, cells, 3, [&](int a, int b) { return between(a, b); });
        const image::Image picture = draw_portable(device, frame, mesh.vertices, mesh.indices);
        for (std::size_t at = 3; at < picture.rgba.size(); at += 4) {
            ASSERT_EQ(picture.rgba[at], 255) << "pixel " << at / 4;
        }
    }
}

// Edges through sample places: the middle of a fan lies on a sample, its rim on others.
TEST_P(Coverage, OfFansAroundASampleIsOnce) {
    const render::Frame frame = flat_frame(64, 64, 1);
    for (int spokes = 3; spokes < 30; ++spokes) {
        Mesh mesh;
        mesh.vertices.push_back(place_vertex(frame, 32 * 256 + 128, 32 * 256 + 128));
        std::vector<std::array<int, 2>> rim;
        const int side = 60 * 256;
        for (int i = 0; i < spokes; ++i) {  // around a square whose corners are sample places
            const int at = 4 * side / spokes * i;
            const int along = at % side;
            const std::array<std::array<int, 2>, 4> places{
                {{along, 0}, {side, along}, {side - along, side}, {0, side - along}}};
            rim.push_back(places[static_cast<std::size_t>(at / side)]);
        }
        for (const auto& [x, y] : rim)
            mesh.vertices.push_back(place_vertex(frame, x + 2 * 256 + 128, y + 2 * 256 + 128));
        for (std::uint32_t i = 0; i < rim.size(); ++i) {
            mesh.indices.insert(mesh.indices.end(), {0, 1 + i, 1 + (i + 1) % static_cast<std::uint32_t>(rim.size())});
        }
        const std::vector<int> counts = coverage_counts(device, frame, mesh.vertices, mesh.indices);
        EXPECT_LE(*std::ranges::max_element(counts), 1);
        EXPECT_EQ(counts[32 * 64 + 32], 1);
    }
}

// A closed surface in perspective: each sample is covered by as many front faces as back faces.
TEST_P(Coverage, OfClosedSurfacesHasTwoSides) {
    TessellationOptions options;
    options.factors = PatchFactors{5, 5, 5, 5, 5, 5};
    const patches::PatchSet set = patches::make_patches(scene::load_scene("shape:sphere:12"));
    const RefinedMesh sphere = tessellate(open_device("reference"), set, options);
    render::Frame frame = flat_frame(120, 120, 1);
    render::Framing framing({}, 1.0f);
    for (const Vertex& v : sphere.vertices)
        framing.add({v.position[0], v.position[1], v.position[2]});
    frame.camera = framing.camera();
    const std::vector<int> counts = coverage_counts(device, frame, sphere.vertices, sphere.indices);
    EXPECT_EQ(std::ranges::count(counts, 1) + std::ranges::count(counts, 3), 0);
    EXPECT_GT(std::ranges::count(counts, 2), 8000);
}

// From inside: triangles reach behind the eye and are clipped, and the sphere around the eye has no hole.
TEST_P(Coverage, FromInsideHasNoHole) {
    const patches::PatchSet set = patches::make_patches(scene::load_scene("shape:sphere:3"));
    const RefinedMesh sphere = tessellate(open_device("reference"), set, {});
    for (const float turn : {0.0f, 0.4f, 1.1f, 2.3f}) {
        render::Frame frame = flat_frame(90, 70, 1);
        frame.camera = render::frame_bounds({glm::vec3(-1e-3f), glm::vec3(1e-3f)}, {turn, turn / 2, 2.0f, 0.02f}, 1.3f);
        frame.camera.projection[2][2] = -1.0f;  // a far plane without end
        frame.camera.projection[3][2] = -0.05f;
        expect_once(coverage_counts(device, frame, sphere.vertices, sphere.indices));
    }
}

TEST_P(Coverage, TiesGoToWhatWasDrawnFirst) {
    const render::Frame frame = flat_frame(40, 40, 4);
    Mesh mesh = random_grid(frame, 6, 2, [&](int a, int b) { return between(a, b); });
    const image::Image once = draw_portable(device, frame, mesh.vertices, mesh.indices);
    // The same surface again with other normals changes nothing.
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        mesh.vertices.push_back(mesh.vertices[i]);
        mesh.vertices.back().normal[0] = 1.0f;
    }
    const std::size_t indices = mesh.indices.size();
    for (std::size_t i = 0; i < indices; ++i)
        mesh.indices.push_back(mesh.indices[i] + count);
    EXPECT_EQ(once.rgba, draw_portable(device, frame, mesh.vertices, mesh.indices).rgba);
}

}  // namespace
}  // namespace tessera::test
