// Pictures by every rasteriser of this machine: those of Vulkan devices, and the portable one on every device; and
// small meshes to draw. Each test fails on any validation message.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "render/rasteriser.hpp"

namespace tessera::test {

/// A mesh as rasterisers take it.
struct DrawnMesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// The rectangle [low, high] at height z, facing +z, uv (0, 0) at its top left and (repeats, repeats) at its bottom
/// right, all with the one normal.
DrawnMesh rectangle(glm::vec2 low, glm::vec2 high, float z, glm::vec3 normal = {0, 0, 1}, float repeats = 1.0f);

/// A sphere around the origin of 2 * segments by segments quadrilaterals.
DrawnMesh sphere(std::uint32_t segments, float radius = 1.0f);

/// Looks along -z without perspective: x and y in [-1, 1] fill the image, z in [-1, 1] is visible, larger is nearer.
render::Camera flat_camera();

using Pixel = std::array<int, 4>;
Pixel pixel_at(const image::Image& image, std::uint32_t x, std::uint32_t y);
/// Expects every channel to be within `tolerance`.
void expect_pixel(const image::Image& image, std::uint32_t x, std::uint32_t y, const Pixel& expected, int tolerance);

/// A linear value as its 8-bit sRGB code.
int srgb(double linear);

/// A device's own rasteriser, or the portable one on it.
struct Drawer {
    std::string device;  ///< as `--device` takes it
    bool portable = false;
};
void PrintTo(const Drawer& drawer, std::ostream* out);
/// "vulkan_1" or "portable_vulkan_1".
std::string drawer_name(const testing::TestParamInfo<Drawer>& drawer);
/// Every rasteriser of this machine.
std::vector<Drawer> drawers();

/// Runs with each of drawers(). What is Vulkan's own is opened for each test, so that its destruction is validated as
/// well.
class Picture : public testing::TestWithParam<Drawer> {
protected:
    void SetUp() override;
    void TearDown() override;

    /// A 64 x 64 picture by the flat camera on a transparent background, of one mesh and material.
    image::Image draw(const DrawnMesh& mesh, const scene::Material& material = {},
                      const std::vector<scene::SceneImage>& images = {});

    render::Frame frame;  ///< what draw() begins with
    gpu::Device device;   ///< of the rasteriser
    std::unique_ptr<render::Rasteriser> rasteriser;
};

}  // namespace tessera::test
