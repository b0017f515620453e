// Triangles far longer than wide, which cover pixels only beside their middles.
#include "raster/portable.hpp"
#include "support/devices.hpp"

namespace tessera::test {
namespace {

// A needle through one of the four samples of every pixel of a row: each pixel has the colour of the place beside it,
// not of one pixels away along the needle.
TEST(Needles, AreShadedWhereTheyAre) {
    render::Frame frame = flat_frame(64, 16, 4);
    frame.shading = render::Shading::uv;
    const int y = 8 * 256 + 96;
    std::vector<Vertex> vertices{place_vertex(frame, 2 * 256, y), place_vertex(frame, 62 * 256, y - 24),
                                 place_vertex(frame, 62 * 256, y + 24)};
    vertices[1].uv[0] = vertices[2].uv[0] = 1.0f;
    scene::Material material;
    material.double_sided = true;
    for (const gpu::Device& device : open_every_device()) {
        const image::Image picture = draw_portable(device, frame, vertices, {0, 1, 2}, material);
        for (std::uint32_t x = 3; x < 61; ++x) {
            const std::uint8_t* pixel = &picture.rgba[(8 * 64 + std::size_t{x}) * 4];
            ASSERT_EQ(pixel[3], 64) << "pixel " << x;
            EXPECT_NEAR(pixel[0], 255.0 * (x + 0.5 - 2.0) / 60.0, 3.0) << device.info().id << ", pixel " << x;
        }
    }
}

}  // namespace
}  // namespace tessera::test
