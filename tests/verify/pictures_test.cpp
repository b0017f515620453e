// Every loadable model, with its textures, gives the same picture to the bit on every device of this machine.
#include "raster/portable_rasteriser.hpp"
#include "scene/scene.hpp"
#include "support/devices.hpp"
#include "support/environment.hpp"
#include "support/manifest.hpp"
#include "verify/compare_pictures.hpp"
#include "verify/compare_rasterisers.hpp"
#include "verify/picture_edges.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>
#include <set>

namespace tessera {
namespace {

/// A model whose images are small enough for many pictures.
struct Shown {
    scene::Scene scene;
    patches::PatchSet patches;
    patches::HairSet hair;
    HairOptions hair_options;

    explicit Shown(const std::string& name) : scene(scene::load_scene(name, {.all_maps = true})) {
        for (scene::SceneImage& image : scene.images) {
            while (std::max(image.pixels.width, image.pixels.height) > 256)
                image.pixels = image::halve(image.pixels);
        }
        patches = patches::make_patches(scene);
    }

    bool is_large() const { return patches.patch_count() > 50'000; }

    verify::PictureSubject subject(Scheme scheme, Partitioning partitioning = Partitioning::fractional_odd) const {
        TessellationOptions options;
        options.scheme = scheme;
        options.partitioning = partitioning;
        const float factor = is_large() ? 1.0f : 2.0f;
        options.factors = PatchFactors{factor, factor, factor, factor, factor, factor};
        return {scene, patches, hair, options, hair_options};
    }
};

/// Sides that are no multiples of a tile; metallic-roughness materials under the model's lights and one of the camera.
std::vector<render::Frame> make_frames(const Shown& model, const render::Camera& camera) {
    render::Frame frame;
    frame.width = 131;
    frame.height = 117;
    frame.camera = camera;
    frame.shading = render::Shading::pbr;
    frame.tone_curve = render::ToneCurve::aces;
    scene::Light light;
    light.fixed_to_camera = true;
    light.direction = frame.reflection.light;
    frame.lights = model.scene.lights;
    frame.lights.push_back(light);
    std::vector<render::Frame> frames{frame, frame};
    frames[0].samples = 1;
    frames[1].samples = 4;
    return frames;
}

std::size_t colours_of(const image::Image& picture) {
    std::set<std::uint32_t> colours;
    for (std::size_t at = 0; at < picture.rgba.size(); at += 4) {
        const std::uint8_t* p = &picture.rgba[at];
        colours.insert(p[0] | std::uint32_t{p[1]} << 8 | std::uint32_t{p[2]} << 16 | std::uint32_t{p[3]} << 24);
    }
    return colours.size();
}

/// Rasterisers stay open from model to model.
class Picture : public testing::TestWithParam<std::string> {
protected:
    static void SetUpTestSuite() { devices = std::make_unique<verify::PictureDevices>(test::open_every_device()); }
    static void TearDownTestSuite() { devices.reset(); }

    static inline std::unique_ptr<verify::PictureDevices> devices;
};

TEST_P(Picture, IsTheSameOnEveryDevice) {
    TESSERA_SHARED_OR_SKIP(shared);
    const Shown model((shared / "models" / GetParam()).string());
    for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn}) {
        if (model.is_large() && scheme != Scheme::pn) continue;  // with factors of 1 they are all the same
        const verify::PictureSubject subject = model.subject(scheme);
        const render::Camera camera = verify::fit_camera(test::open_device("reference"), subject, 131.0f / 117.0f);
        std::vector<image::Image> pictures;
        const auto results = devices->compare(subject, make_frames(model, camera), &pictures);
        for (const verify::PictureComparison& result : results) {
            EXPECT_EQ(result.pixels, 2u * 131u * 117u);
            EXPECT_EQ(result.differing, 0u) << result.device.id << ", " << name(scheme) << ", "
                                            << (result.first ? verify::describe(*result.first) : "");
        }
        for (const image::Image& picture : pictures)
            EXPECT_GT(colours_of(picture), 3u) << "next to nothing was drawn";
    }
}

/// A device's own rasteriser beside the portable one.
class OwnPicture : public testing::TestWithParam<std::string> {
protected:
    static void SetUpTestSuite() {
        portable = raster::open_portable(test::open_device("reference"));
        for (const gpu::DeviceInfo& info : test::machine().devices) {
            if (info.rasteriser) own.emplace_back(info.id, backends::open_rasteriser(info.id));
        }
    }
    static void TearDownTestSuite() {
        own.clear();
        portable.reset();
    }

    static inline std::unique_ptr<render::Rasteriser> portable;
    static inline std::vector<std::pair<std::string, std::unique_ptr<render::Rasteriser>>> own;
};

// Where hardware extrapolates a colour beyond a needle of a triangle, it is not ours to follow: even factors make none.
TEST_P(OwnPicture, IsCloseToThePortableOne) {
    TESSERA_SHARED_OR_SKIP(shared);
    const Shown model((shared / "models" / GetParam()).string());
    for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn}) {
        if (model.is_large() && scheme != Scheme::pn) continue;
        const gpu::Device device = test::open_device("reference");
        const verify::PictureSubject subject = model.subject(scheme, Partitioning::integer);
        render::Frame frame;
        frame.width = 160;
        frame.height = 144;
        frame.camera = verify::fit_camera(device, subject, 160.0f / 144.0f);
        for (const auto& [id, rasteriser] : own) {
            const verify::RasteriserComparison result =
                verify::compare_rasterisers(device, subject, frame, *rasteriser, *portable);
            // SwiftShader's vertices lie on 16 places to a pixel, which small triangles show.
            const bool is_coarse = test::open_device(id).info().name.find("SwiftShader") != std::string::npos;
            EXPECT_LE(result.flip_mean, is_coarse ? 1.5 * verify::most_flip : verify::most_flip)
                << id << ", " << name(scheme);
            EXPECT_EQ(result.off_edges, 0u)
                << id << ", " << name(scheme) << ": " << (result.first ? verify::describe(*result.first) : "");
        }
    }
}

/// Two of the faces of obj/deg_faces.obj lie in each other: which one is seen is for each rasteriser to say.
std::vector<std::string> models_with_one_picture() {
    std::vector<std::string> files = test::loadable_models();
    std::erase(files, "obj/deg_faces.obj");
    return files;
}

INSTANTIATE_TEST_SUITE_P(Shared, OwnPicture, testing::ValuesIn(models_with_one_picture()),
                         [](const auto& info) { return test::file_test_name(info.param); });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(OwnPicture);

TEST(Edges, AreWhereACubeHasThem) {
    const Shown model("shape:cube");
    const gpu::Device device = test::open_device("reference");
    const verify::PictureSubject subject = model.subject(Scheme::linear);
    render::Frame frame;
    frame.width = frame.height = 100;
    frame.camera = verify::fit_camera(device, subject, 1.0f);
    const auto portable = raster::open_portable(device);
    const std::vector<bool> edges = verify::find_edges(device, subject, *portable, frame);
    const image::Image picture = verify::draw_picture(device, subject, *portable, frame);
    ASSERT_EQ(edges.size(), 10'000u);
    EXPECT_FALSE(edges[0]);
    for (std::size_t at = 0; at + 1 < edges.size(); ++at) {
        const bool begins = std::abs(picture.rgba[at * 4] - picture.rgba[at * 4 + 4]) > 20;
        EXPECT_TRUE(!begins || (edges[at] && edges[at + 1])) << at;
    }
    const auto marked = std::ranges::count(edges, true);
    EXPECT_GT(marked, 500);
    EXPECT_LT(marked, 2500);
}

INSTANTIATE_TEST_SUITE_P(Shared, Picture, testing::ValuesIn(test::loadable_models()),
                         [](const auto& info) { return test::file_test_name(info.param); });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Picture);

TEST(Pictures, OfLoadableModelsAreTested) {
    TESSERA_SHARED_OR_SKIP(shared);
    EXPECT_GE(test::loadable_models().size(), 44u) << "the MANIFEST was not understood";
}

}  // namespace
}  // namespace tessera
