// Wrong calls are refused with the value that is wrong, and the rasteriser is as good as new afterwards.
#include "backends/vulkan/vulkan_backend.hpp"
#include "base/error.hpp"
#include "render/picture_suite.hpp"

namespace tessera::test {
namespace {

class Misuse : public Picture {
protected:
    template <typename Action>
    static void expect_refusal(const Action& action, const std::string& value) {
        try {
            action();
            ADD_FAILURE() << "was not refused: " << value;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
            EXPECT_NE(std::string(error.what()).find(value), std::string::npos) << error.what();
        }
    }
};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Misuse);
INSTANTIATE_TEST_SUITE_P(By, Misuse, testing::ValuesIn(drawers()), drawer_name);

TEST_P(Misuse, OfSizesIsRefused) {
    for (const auto& [width, height] : {std::pair{0u, 64u}, {64u, 0u}, {8193u, 64u}, {64u, 4000000000u}}) {
        frame.width = width;
        frame.height = height;
        expect_refusal([&] { rasteriser->begin(frame); }, std::to_string(width) + " x " + std::to_string(height));
    }
}

TEST_P(Misuse, OfOrderIsRefused) {
    expect_refusal([&] { rasteriser->finish(); }, "finish");
    expect_refusal([&] { rasteriser->draw({}, {}, 0); }, "draw");
    expect_refusal([&] { rasteriser->set_materials({{}}, {}); }, "set_materials");
    rasteriser->begin(frame);
    expect_refusal([&] { rasteriser->draw({}, {}, 0); }, "draw");
}

TEST_P(Misuse, OfMeshesIsRefused) {
    const DrawnMesh mesh = rectangle({-1, -1}, {1, 1}, 0);
    const std::vector<std::uint32_t> beyond{0, 1, 4};
    rasteriser->begin(frame);
    rasteriser->set_materials({{}}, {});
    expect_refusal([&] { rasteriser->draw(mesh.vertices, beyond, 0); }, "index 4");
    expect_refusal([&] { rasteriser->draw(mesh.vertices, std::span(mesh.indices).first(4), 0); }, "4 indices");
    expect_refusal([&] { rasteriser->draw(mesh.vertices, mesh.indices, 1); }, "material 1");
    const std::vector<VertexAttributes> few(mesh.vertices.size() - 1);
    expect_refusal([&] { rasteriser->draw(render::Draw{mesh.vertices, mesh.indices, 0, few}); }, "attributes of 3");
    expect_pixel(draw(mesh), 30, 30, {128, 128, 255, 255}, 1);
}

TEST_P(Misuse, OfImagesIsRefused) {
    scene::Material material;
    material.base_color_image = 1;
    rasteriser->begin(frame);
    expect_refusal([&] { rasteriser->set_materials({material}, {scene::SceneImage{}}); }, "image 1");
    material.base_color_image = 0;
    scene::SceneImage empty;
    empty.name = "hollow";
    expect_refusal([&] { rasteriser->set_materials({material}, {empty}); }, "hollow");
    expect_pixel(draw(rectangle({-1, -1}, {1, 1}, 0)), 30, 30, {128, 128, 255, 255}, 1);
}

TEST(OpenRasteriser, RefusesADeviceThatIsNotThere) {
    try {
        backends::vulkan::open(1000);
        ADD_FAILURE() << "device 1000 was opened";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::device_unavailable);
    }
}

}  // namespace
}  // namespace tessera::test
