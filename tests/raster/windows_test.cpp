// Pictures larger than a window, and lists longer than their buffer.
#include "raster/portable.hpp"
#include "support/devices.hpp"

#include "raster/raster_pipeline.hpp"
#include "raster/raster_window.hpp"

namespace tessera::test {
namespace {

TEST(Windows, MeetWithoutASeam) {
    constexpr std::uint32_t side = 2048;
    const render::Frame frame = flat_frame(2 * side + 40, 70, 1);
    // Slanted triangles over all three windows, each sample once.
    const int right = static_cast<int>(frame.width) * 256;
    const int bottom = 70 * 256;
    const std::vector<Vertex> vertices{place_vertex(frame, 0, 0), place_vertex(frame, 0, bottom),
                                       place_vertex(frame, right, bottom), place_vertex(frame, right, 0),
                                       place_vertex(frame, right / 2 + 77, 31 * 256 + 5)};
    const std::vector<int> counts =
        coverage_counts(open_device("reference"), frame, vertices, {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4});
    EXPECT_EQ(counts, std::vector<int>(counts.size(), 1));
}

TEST(Windows, AreAsLargeAsABindingAllows) {
    for (const gpu::Device& device : open_every_device()) {
        const std::uint64_t side = raster::choose_launch(device.info()).window;
        EXPECT_LE(side * side * 4 * 4, device.limits().max_storage_binding_size);
    }
}

// Triangles that fill half of 2048 x 2048 pixels: more entries than one binning may list.
TEST(Lists, ThatAreTooLongAreCut) {
    const render::Frame frame = flat_frame(2048, 2048, 1);
    const std::vector<Vertex> vertices{place_vertex(frame, 0, 0), place_vertex(frame, 0, 2048 * 256),
                                       place_vertex(frame, 2048 * 256, 2048 * 256)};
    std::vector<std::uint32_t> indices;
    const std::uint64_t tiles = 128 * 128;
    const std::uint64_t triangles = raster::RasterPipeline::max_list_words / tiles + 500;
    for (std::uint64_t i = 0; i < triangles; ++i)
        indices.insert(indices.end(), {0, 1, 2});
    const image::Image once = draw_portable(open_device("reference"), frame, vertices, {0, 1, 2});
    EXPECT_EQ(once.rgba, draw_portable(open_device("reference"), frame, vertices, indices).rgba);
}

}  // namespace
}  // namespace tessera::test
