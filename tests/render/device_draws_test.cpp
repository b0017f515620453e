// Draws from device memory: the picture of the same mesh in host memory, without a vertex read back.
#include "render/mesh_sinks.hpp"
#include "render/picture_suite.hpp"
#include "render/resident_mesh.hpp"
#include "tessellate/scene_tessellator.hpp"

namespace tessera::test {
namespace {

class DeviceDraws : public Picture {
protected:
    bool draws_from_device() {
        rasteriser->begin(frame);
        return rasteriser->draws_from(device);
    }
};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(DeviceDraws);
INSTANTIATE_TEST_SUITE_P(By, DeviceDraws, testing::ValuesIn(drawers()), drawer_name);

/// A DrawSink that takes nothing from the device.
class HostSink final : public MeshSink {
public:
    explicit HostSink(render::DrawSink& sink) : sink_(sink) {}
    void append(const MeshBatch& batch) override {
        sink_.append(batch);
        ++batches;
    }

    int batches = 0;

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
        options.memory_budget = std::uint64_t{700} << 10;
    }
};

image::Image draw_model(const Model& model, const gpu::Device& device, render::Rasteriser& rasteriser,
                        const render::Frame& frame, bool from_device) {
    SceneTessellator tessellator(device, model.set, model.options, {}, {});
    rasteriser.begin(frame);
    rasteriser.set_materials(model.scene.materials, {});
    render::DrawSink sink(rasteriser, tessellator.totals().parts);
    HostSink host(sink);
    const std::uint64_t read = device.traffic().read;
    tessellator.run(from_device ? static_cast<MeshSink&>(sink) : host, Space::kernel);
    const std::uint64_t output = tessellator.totals().vertex_count * sizeof(Vertex);
    EXPECT_EQ(device.traffic().read - read < output, from_device);
    EXPECT_EQ(host.batches > 2, !from_device);
    return rasteriser.finish();
}

TEST_P(DeviceDraws, ShowWhatDrawsOfTheHostShow) {
    std::vector<render::Shading> shadings{render::Shading::phong, render::Shading::normals};
    if (GetParam().portable) shadings.insert(shadings.end(), {render::Shading::pbr, render::Shading::wireframe});
    for (const bool colors : {false, true}) {
        const Model model(colors);
        for (const render::Shading shading : shadings) {
            frame.shading = shading;
            if (!draws_from_device()) GTEST_SKIP() << "indices of this device have fewer than 32 bits";
            const image::Image expected = draw_model(model, device, *rasteriser, frame, false);
            EXPECT_NE(expected.rgba, std::vector<std::uint8_t>(expected.rgba.size(), expected.rgba.front()));
            EXPECT_EQ(draw_model(model, device, *rasteriser, frame, true).rgba, expected.rgba)
                << "shading " << static_cast<int>(shading) << (colors ? ", colours" : "");
        }
    }
}

TEST_P(DeviceDraws, OfAResidentMeshCanBeRepeated) {
    const DrawnMesh mesh = sphere(40, 0.9f);
    const image::Image expected = Picture::draw(mesh);
    if (!draws_from_device()) GTEST_SKIP() << "indices of this device have fewer than 32 bits";
    const render::DeviceDraw resident = render::upload_mesh(device, mesh.vertices, mesh.indices);
    for (int picture = 0; picture < 3; ++picture) {
        rasteriser->begin(frame);
        rasteriser->set_materials({{}}, {});
        rasteriser->draw(resident);
        EXPECT_EQ(rasteriser->finish().rgba, expected.rgba);
    }
}

TEST_P(DeviceDraws, MixWithDrawsOfTheHost) {
    const DrawnMesh below = rectangle({-1, -1}, {1, 0.2f}, 0), above = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, 0.5f);
    const auto both = [&](bool resident) {
        rasteriser->begin(frame);
        rasteriser->set_materials({{}}, {});
        rasteriser->draw(below.vertices, below.indices, 0);
        if (resident) {
            rasteriser->draw(render::upload_mesh(device, above.vertices, above.indices));
        } else {
            rasteriser->draw(above.vertices, above.indices, 0);
        }
        rasteriser->draw(below.vertices, below.indices, 0);
        return rasteriser->finish().rgba;
    };
    const auto expected = both(false);
    if (!draws_from_device()) GTEST_SKIP() << "indices of this device have fewer than 32 bits";
    EXPECT_EQ(both(true), expected);
}

TEST_P(DeviceDraws, OfAWireframeAreRefusedByOwnRasterisers) {
    if (GetParam().portable) GTEST_SKIP() << "the portable one draws them";
    frame.shading = render::Shading::wireframe;
    EXPECT_FALSE(draws_from_device());
}

}  // namespace
}  // namespace tessera::test
