#include "render/picture_suite.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "backends/vulkan/instance.hpp"
#include "backends/vulkan/validation.hpp"
#include "raster/portable_rasteriser.hpp"
#include "support/devices.hpp"
#include "support/environment.hpp"

namespace tessera::test {

namespace vulkan = backends::vulkan;

namespace {

/// Whether Vulkan devices are among those of this machine.
bool has_vulkan() {
    return std::ranges::any_of(machine().devices, [](const gpu::DeviceInfo& info) { return info.backend == "vulkan"; });
}

/// Lavapipe keeps state for as long as it is loaded; unloaded with the last instance, it would look leaked.
void keep_drivers_loaded() {
    static const auto* const instance = new std::shared_ptr<const vulkan::Instance>(vulkan::shared_instance());
    ASSERT_TRUE(*instance);
}

}  // namespace

DrawnMesh rectangle(glm::vec2 low, glm::vec2 high, float z, glm::vec3 normal, float repeats) {
    const auto corner = [&](float x, float y, float u, float v) {
        return Vertex{{x, y, z}, {normal.x, normal.y, normal.z}, {u, v}};
    };
    return {{corner(low.x, low.y, 0.0f, repeats), corner(high.x, low.y, repeats, repeats),
             corner(high.x, high.y, repeats, 0.0f), corner(low.x, high.y, 0.0f, 0.0f)},
            {0, 1, 2, 0, 2, 3}};
}

DrawnMesh sphere(std::uint32_t segments, float radius) {
    DrawnMesh mesh;
    const std::uint32_t columns = 2 * segments + 1;
    for (std::uint32_t row = 0; row <= segments; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const float v = static_cast<float>(row) / static_cast<float>(segments);
            const float u = static_cast<float>(column) / static_cast<float>(2 * segments);
            const float down = v * std::numbers::pi_v<float>;
            const float around = u * 2.0f * std::numbers::pi_v<float>;
            const glm::vec3 n(std::sin(down) * std::sin(around), std::cos(down), std::sin(down) * std::cos(around));
            mesh.vertices.push_back({{n.x * radius, n.y * radius, n.z * radius}, {n.x, n.y, n.z}, {u, v}});
        }
    }
    for (std::uint32_t row = 0; row < segments; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t a = row * columns + column;
            const std::uint32_t b = a + columns;
            mesh.indices.insert(mesh.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    }
    return mesh;
}

render::Camera flat_camera() {
    render::Camera camera;
    camera.projection = glm::mat4(0.0f);
    camera.projection[0][0] = 1.0f;
    camera.projection[1][1] = -1.0f;
    camera.projection[2][2] = -0.5f;
    camera.projection[3][2] = 0.5f;
    camera.projection[3][3] = 1.0f;
    return camera;
}

Pixel pixel_at(const image::Image& image, std::uint32_t x, std::uint32_t y) {
    const std::uint8_t* p = &image.rgba.at((std::size_t{y} * image.width + x) * 4);
    return {p[0], p[1], p[2], p[3]};
}

void expect_pixel(const image::Image& image, std::uint32_t x, std::uint32_t y, const Pixel& expected, int tolerance) {
    const Pixel found = pixel_at(image, x, y);
    for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_NEAR(found[c], expected[c], tolerance) << "pixel " << x << ", " << y << ", channel " << c;
    }
}

int srgb(double linear) {
    const double encoded = linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    return static_cast<int>(std::lround(encoded * 255.0));
}

void Picture::SetUp() {
    if (has_vulkan()) keep_drivers_loaded();
    vulkan::take_validation_messages();
    frame.width = 64;
    frame.height = 64;
    frame.camera = flat_camera();
    frame.shading = render::Shading::normals;
    frame.background = glm::vec4(0.0f);
    device = GetParam().portable ? open_device(GetParam().device) : backends::open_device(GetParam().device);
    rasteriser = GetParam().portable ? raster::open_portable(device) : backends::open_rasteriser(device);
    if (has_vulkan()) {
        EXPECT_EQ(vulkan::validation_active(), vulkan::validation_wanted());
    }
}

void Picture::TearDown() {
    rasteriser.reset();
    device = {};
    for (const std::string& message : vulkan::take_validation_messages())
        ADD_FAILURE() << message;
}

image::Image Picture::draw(const DrawnMesh& mesh, const scene::Material& material,
                           const std::vector<scene::SceneImage>& images) {
    rasteriser->begin(frame);
    rasteriser->set_materials({material}, images);
    rasteriser->draw(mesh.vertices, mesh.indices, 0);
    return rasteriser->finish();
}

void PrintTo(const Drawer& drawer, std::ostream* out) {
    *out << (drawer.portable ? "portable on " : "") << drawer.device;
}

std::string drawer_name(const testing::TestParamInfo<Drawer>& drawer) {
    std::string name = (drawer.param.portable ? "portable_" : "") + drawer.param.device;
    std::ranges::replace(name, ':', '_');
    return name;
}

std::vector<Drawer> drawers() {
    std::vector<Drawer> found;
    for (const gpu::DeviceInfo& info : machine().devices) {
        if (info.rasteriser) found.push_back({info.id, false});
        found.push_back({info.id, true});
    }
    return found;
}

TEST(PictureDevices, AreThere) {
    if (std::ranges::any_of(drawers(), [](const Drawer& drawer) { return !drawer.portable; })) return;
    if (everything_required()) FAIL() << "no Vulkan device draws";
    GTEST_SKIP() << "no Vulkan device draws: its pictures are not tested";
}

}  // namespace tessera::test
