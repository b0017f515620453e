// Models with their textures: the same picture to the bit from every device, close to that of a device's own
// rasteriser.
#include "raster/portable.hpp"
#include "raster/portable_rasteriser.hpp"
#include "render/mesh_sinks.hpp"
#include "scene/scene.hpp"
#include "support/devices.hpp"
#include "support/environment.hpp"
#include "tessellate/tessellate.hpp"

#include <algorithm>

namespace tessera::test {
namespace {

/// A tessellated model, and a frame that shows it.
struct Subject {
    scene::Scene scene;
    RefinedMesh mesh;
    render::Frame frame;

    explicit Subject(const std::string& name, float factor = 3, bool all_maps = false)
        : scene(scene::load_scene(name, {.all_maps = all_maps})) {
        TessellationOptions options;
        options.factors = PatchFactors{factor, factor, factor, factor, factor, factor};
        const patches::PatchSet set = patches::make_patches(scene);
        Tessellator tessellator(open_device("reference"), set, options);
        tessellator.run(mesh, Space::kernel);
        mesh.parts = tessellator.totals().parts;
        frame.width = 300;
        frame.height = 260;
        render::Framing framing({}, 300.0f / 260.0f);
        for (const Vertex& v : mesh.vertices)
            framing.add({v.position[0], v.position[1], v.position[2]});
        frame.camera = framing.camera();
    }

    image::Image draw(render::Rasteriser& rasteriser) const {
        rasteriser.begin(frame);
        rasteriser.set_materials(scene.materials, scene.images);
        render::DrawSink sink(rasteriser, mesh.parts);
        sink.append({0, 0, mesh.vertices, mesh.indices, {}, {}, mesh.attributes});
        return rasteriser.finish();
    }
};

class PortableModel : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Shared, PortableModel,
                         testing::Values("Fox/Fox.glb", "Avocado/Avocado.gltf", "SuzanneBlender/02_suzanne.gltf",
                                         "spot/spot_control_mesh.obj", "RetroUFO/retroufo.glb",
                                         "RiggedFigure/RiggedFigure.glb"));

TEST_P(PortableModel, HasTheSameBitsOnEveryDevice) {
    TESSERA_SHARED_OR_SKIP(shared);
    Subject subject((shared / "models" / GetParam()).string());
    for (const std::uint32_t samples : {1u, 4u}) {
        for (const auto shading : {render::Shading::phong, render::Shading::normals, render::Shading::wireframe}) {
            subject.frame.samples = samples;
            subject.frame.shading = shading;
            std::optional<image::Image> first;
            for (const gpu::Device& device : open_every_device()) {
                const image::Image picture = subject.draw(*raster::open_portable(device));
                if (!first) {
                    first = picture;
                    const std::vector<std::uint8_t> pixel(picture.rgba.begin(), picture.rgba.begin() + 4);
                    std::size_t drawn = 0;
                    for (std::size_t at = 0; at < picture.rgba.size(); at += 4) {
                        drawn += std::equal(pixel.begin(), pixel.end(), picture.rgba.begin() + static_cast<long>(at))
                                     ? 0
                                     : 1;
                    }
                    EXPECT_GT(drawn, picture.rgba.size() / 4 / 12) << "next to nothing was drawn";
                } else {
                    EXPECT_EQ(picture.rgba, first->rgba) << device.info().id << ", " << samples << " samples";
                }
            }
        }
    }
}

TEST_P(PortableModel, HasTheSameBitsWithMetallicRoughnessMaterials) {
    TESSERA_SHARED_OR_SKIP(shared);
    Subject subject((shared / "models" / GetParam()).string(), 2, true);
    subject.frame.shading = render::Shading::pbr;
    subject.frame.tone_curve = render::ToneCurve::aces;
    scene::Light light;
    light.fixed_to_camera = true;
    light.direction = subject.frame.reflection.light;
    subject.frame.lights = {light};
    const image::Image first = subject.draw(*raster::open_portable(open_device("reference")));
    subject.scene.materials.front().base_color = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
    EXPECT_NE(subject.draw(*raster::open_portable(open_device("reference"))).rgba, first.rgba);
    subject = Subject((shared / "models" / GetParam()).string(), 2, true);
    subject.frame.shading = render::Shading::pbr;
    subject.frame.tone_curve = render::ToneCurve::aces;
    subject.frame.lights = {light};
    for (const gpu::Device& device : open_every_device()) {
        EXPECT_EQ(subject.draw(*raster::open_portable(device)).rgba, first.rgba) << device.info().id;
    }
}

TEST_P(PortableModel, IsCloseToTheDevicesOwnRasteriser) {
    TESSERA_SHARED_OR_SKIP(shared);
    Subject subject((shared / "models" / GetParam()).string());
    for (const gpu::DeviceInfo& info : machine().devices) {
        if (!info.rasteriser) continue;
        for (const auto shading : {render::Shading::phong, render::Shading::normals, render::Shading::wireframe}) {
            subject.frame.shading = shading;
            const image::Image own = subject.draw(*backends::open_rasteriser(info.id));
            const image::Image portable = subject.draw(*raster::open_portable(open_device("reference")));
            const image::Difference difference = image::difference(own, portable, 16);
            // Steps of 8 bits; a wireframe of small triangles is all edges.
            EXPECT_LT(difference.mean, shading == render::Shading::wireframe ? 0.5 : 0.3) << info.id;
            EXPECT_LT(difference.count_over, own.rgba.size() / 4 / 20) << info.id;
        }
    }
}

}  // namespace
}  // namespace tessera::test
