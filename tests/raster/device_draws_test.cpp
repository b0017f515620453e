// Draws from parts of buffers, and from wrong ones.
#include "base/error.hpp"
#include "raster/portable.hpp"
#include "raster/portable_rasteriser.hpp"
#include "render/resident_mesh.hpp"
#include "support/devices.hpp"

#include <gtest/gtest.h>

namespace tessera::test {
namespace {

constexpr auto usage = gpu::BufferUsage::storage | gpu::BufferUsage::copy_destination;

/// A square of two triangles behind `unused` other vertices and indices, named from `base`.
struct DeviceSquare {
    gpu::Device device;
    render::Frame frame = flat_frame(20, 20, 1);
    render::DeviceDraw draw;

    DeviceSquare(const gpu::Device& where, std::uint32_t unused, std::uint32_t base, std::uint32_t last_index)
        : device(where) {
        std::vector<Vertex> vertices(unused, place_vertex(frame, 0, 0));
        for (const auto& [x, y] : {std::pair{2, 2}, {18, 2}, {18, 18}, {2, 18}}) {
            vertices.push_back(place_vertex(frame, x * 256, y * 256));
        }
        std::vector<std::uint32_t> indices(unused, 1000000u);
        for (const std::uint32_t i : {0u, 2u, 1u, 0u, 3u, last_index}) {
            indices.push_back(base + i);
        }
        draw.vertices = device.create_buffer({"vertices", vertices.size() * sizeof(Vertex), usage});
        draw.indices = device.create_buffer({"indices", indices.size() * 4, usage});
        device.queue().write_buffer(draw.vertices, 0, std::as_bytes(std::span(vertices)));
        device.queue().write_buffer(draw.indices, 0, std::as_bytes(std::span(indices)));
        draw.first_vertex = unused;
        draw.vertex_count = 4;
        draw.first_index = unused;
        draw.index_count = 6;
        draw.index_base = base;
    }

    /// Pixels that are not of the background.
    std::size_t drawn() const {
        const auto rasteriser = raster::open_portable(device);
        rasteriser->begin(frame);
        rasteriser->set_materials({{}}, {});
        rasteriser->draw(draw);
        const image::Image picture = rasteriser->finish();
        std::size_t count = 0;
        for (std::size_t at = 3; at < picture.rgba.size(); at += 4) {
            count += picture.rgba[at] != 0 ? 1 : 0;
        }
        return count;
    }
};

TEST(DeviceDraws, MayBePartOfBuffers) {
    for (const gpu::Device& device : open_every_device()) {
        for (const std::uint32_t unused : {0u, 1u, 33u}) {
            EXPECT_EQ(DeviceSquare(device, unused, 7, 2).drawn(), 256u) << device.info().id << ", after " << unused;
        }
    }
}

TEST(DeviceDraws, DropTrianglesWithOtherVertices) {
    for (const gpu::Device& device : open_every_device()) {
        for (const std::uint32_t base : {0u, 7u}) {
            EXPECT_EQ(DeviceSquare(device, 3, base, 4).drawn(), 136u) << device.info().id;
            EXPECT_EQ(DeviceSquare(device, 3, base, 0u - base - 1u).drawn(), 136u) << device.info().id;
        }
    }
}

/// More triangles than any device draws at a time: a grid of squares, each of which covers the middle of a pixel; later
/// ones are nearer or farther in turns.
TEST(DeviceDraws, OfManyTrianglesAreCutWithoutTrace) {
    constexpr std::uint32_t side = 128, layers = 17;  // 557,056 triangles, more than 2^19
    const render::Frame frame = flat_frame(side, side, 1);
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        const float z = (layer % 2 == 0 ? 1.0f : -1.0f) * 0.05f * static_cast<float>(layer);
        for (std::uint32_t i = 0; i < side * side; ++i) {
            const auto x = static_cast<int>(i % side * 256), y = static_cast<int>(i / side * 256);
            const auto first = static_cast<std::uint32_t>(vertices.size());
            for (const auto& [dx, dy] : {std::pair{0, 0}, {256, 0}, {256, 256}, {0, 256}}) {
                vertices.push_back(place_vertex(frame, x + dx, y + dy, z));
                vertices.back().normal[0] = 0.1f * static_cast<float>(layer);
            }
            for (const std::uint32_t corner : {0u, 2u, 1u, 0u, 3u, 2u}) {
                indices.push_back(first + corner);
            }
        }
    }
    ASSERT_GT(indices.size() / 3, std::size_t{1} << 19);
    for (const gpu::DeviceInfo& info : machine().devices) {
        if (info.backend == "vulkan") continue;  // whose batches are smaller, and tested with smaller meshes
        const std::string& id = info.id;
        const gpu::Device device = open_device(id);
        const auto rasteriser = raster::open_portable(device);
        const auto picture = [&](std::size_t draws) {
            rasteriser->begin(frame);
            rasteriser->set_materials({{}}, {});
            render::DeviceDraw all = render::upload_mesh(device, vertices, indices);
            const std::uint64_t share = indices.size() / draws;
            for (std::size_t i = 0; i < draws; ++i) {
                all.first_index = i * share;
                all.index_count = share;
                rasteriser->draw(all);
            }
            return rasteriser->finish();
        };
        const image::Image whole = picture(1);
        EXPECT_EQ(whole.rgba, picture(layers).rgba) << id;
        const image::Image last = draw_portable(device, frame, {vertices.end() - 4 * side * side, vertices.end()},
                                                {indices.begin(), indices.begin() + 6 * side * side});
        EXPECT_EQ(whole.rgba, last.rgba) << id << ": the last layer is the nearest";
    }
}

TEST(DeviceDraws, AreRefusedWithoutTheirBuffers) {
    const auto refused = [](auto&& change) {
        DeviceSquare square(open_device("reference"), 0, 0, 2);
        change(square.draw);
        EXPECT_THROW(square.drawn(), Error);
    };
    refused([](render::DeviceDraw& d) { d.vertices = {}; });
    refused([](render::DeviceDraw& d) { d.indices = {}; });
    refused([](render::DeviceDraw& d) { d.material = 1; });
    refused([](render::DeviceDraw& d) { d.index_count = 5; });
    refused([](render::DeviceDraw& d) { d.first_index = 3; });
    refused([](render::DeviceDraw& d) { d.vertex_count = 5; });
    refused([](render::DeviceDraw& d) { d.first_vertex = ~std::uint64_t{0}; });
    refused([](render::DeviceDraw& d) { d.attributes = d.indices; });
}

}  // namespace
}  // namespace tessera::test
