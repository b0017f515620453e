// Every loadable model, with its textures, gives the same picture to the bit on every device of this machine.
#include "scene/scene.hpp"
#include "support/devices.hpp"
#include "support/environment.hpp"
#include "support/manifest.hpp"
#include "verify/compare_pictures.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <set>

namespace tessera {
namespace {

/// A model whose images are small enough for many pictures.
struct Model {
    scene::Scene scene;
    patches::PatchSet patches;
    patches::HairSet hair;
    HairOptions hair_options;

    explicit Model(const std::string& name) : scene(scene::load_scene(name, {.all_maps = true})) {
        for (scene::SceneImage& image : scene.images) {
            while (std::max(image.pixels.width, image.pixels.height) > 256)
                image.pixels = image::halve(image.pixels);
        }
        patches = patches::make_patches(scene);
    }

    bool is_large() const { return patches.patch_count() > 50'000; }

    verify::PictureSubject subject(Scheme scheme) const {
        TessellationOptions options;
        options.scheme = scheme;
        const float factor = is_large() ? 1.0f : 2.0f;
        options.factors = PatchFactors{factor, factor, factor, factor, factor, factor};
        return {scene, patches, hair, options, hair_options};
    }
};

/// Sides that are no multiples of a tile; metallic-roughness materials under the model's lights and one of the camera.
std::vector<render::Frame> make_frames(const Model& model, const render::Camera& camera) {
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
    const Model model((shared / "models" / GetParam()).string());
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

INSTANTIATE_TEST_SUITE_P(Shared, Picture, testing::ValuesIn(test::loadable_models()),
                         [](const auto& info) { return test::file_test_name(info.param); });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Picture);

TEST(Pictures, OfLoadableModelsAreTested) {
    TESSERA_SHARED_OR_SKIP(shared);
    EXPECT_GE(test::loadable_models().size(), 44u) << "the MANIFEST was not understood";
}

}  // namespace
}  // namespace tessera
