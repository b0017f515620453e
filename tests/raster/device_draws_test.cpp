// Draws from device memory: the picture of the same mesh in host memory, without a vertex read back.
#include "base/error.hpp"
#include "raster/portable.hpp"
#include "raster/portable_rasteriser.hpp"
#include "render/mesh_sinks.hpp"
#include "support/devices.hpp"
#include "tessellate/scene_tessellator.hpp"

#include <gtest/gtest.h>

namespace tessera::test {
namespace {

constexpr auto usage = gpu::BufferUsage::storage | gpu::BufferUsage::copy_destination;

/// A DrawSink that takes nothing from the device.
class HostSink final : public MeshSink {
public:
    explicit HostSink(render::DrawSink& sink) : sink_(sink) {}
    void append(const MeshBatch& batch) override { sink_.append(batch); }

private:
    render::DrawSink& sink_;
};

/// A model in several parts, with colours where `colors`, in batches so small that they cut through parts.
struct Model {
    scene::Scene scene = scene::load_scene("shape:cube");
    patches::PatchSet set;
    TessellationOptions options;

    explicit Model(bool colors) {
        scene::Mesh second = scene.meshes.front();
        for (glm::vec3& position : second.positions) {
            position += glm::vec3(0.5f, 0.25f, 0.125f);
        }
        second.material = 1;
        scene.materials.resize(2);
        scene.materials[1].base_color = glm::vec4(0.9f, 0.3f, 0.1f, 0.5f);
        scene.materials[1].alpha_mode = scene::AlphaMode::blend;
        scene.meshes.push_back(second);
        set = patches::make_patches(scene);
        if (colors) {
            set.has_colors = true;
            set.corner_attributes.resize(set.patch_count());
            for (std::size_t i = 0; i < set.patch_count(); ++i) {
                for (std::size_t corner = 0; corner < 4; ++corner) {
                    float* color = set.corner_attributes[i][corner].color;
                    color[0] = 0.25f * static_cast<float>(corner);
                    color[1] = 1.0f;
                    color[2] = i % 2 == 0 ? 1.0f : 0.0f;
                    color[3] = 1.0f;
                }
            }
        }
        options.factors = PatchFactors{40, 40, 40, 40, 40, 40};
        options.scheme = Scheme::pn;
        options.memory_budget = std::uint64_t{512} << 10;
    }

    image::Image draw(const gpu::Device& device, render::Shading shading, bool from_device) const {
        SceneTessellator tessellator(device, set, options, {}, {});
        render::Frame frame = flat_frame(90, 70, 4);
        frame.shading = shading;
        const auto rasteriser = raster::open_portable(device);
        rasteriser->begin(frame);
        rasteriser->set_materials(scene.materials, {});
        render::DrawSink sink(*rasteriser, tessellator.totals().parts);
        HostSink host(sink);
        const std::uint64_t read = device.traffic().read;
        tessellator.run(from_device ? static_cast<MeshSink&>(sink) : host, Space::kernel);
        const std::uint64_t output = tessellator.totals().vertex_count * sizeof(Vertex);
        EXPECT_EQ(device.traffic().read - read < output, from_device);
        return rasteriser->finish();
    }
};

TEST(DeviceDraws, ShowWhatDrawsOfTheHostShow) {
    for (const bool colors : {false, true}) {
        const Model model(colors);
        for (const auto shading : {render::Shading::phong, render::Shading::pbr, render::Shading::uv}) {
            const image::Image expected = model.draw(open_device("reference"), shading, false);
            for (const gpu::Device& device : open_every_device()) {
                EXPECT_EQ(model.draw(device, shading, true).rgba, expected.rgba)
                    << device.info().id << ", shading " << static_cast<int>(shading) << (colors ? ", colours" : "");
            }
        }
    }
}

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
