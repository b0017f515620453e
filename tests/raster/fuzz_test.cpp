// Triangles of any floats at all: nothing is read or written out of place, and every device draws the same.
#include "raster/portable.hpp"
#include "support/devices.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace tessera::test {
namespace {

/// Coordinates of every kind: sound ones mostly, else special ones, huge and tiny ones, and any bits.
float wild(std::mt19937& random) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float special[] = {0.0f,    -0.0f,  infinity, -infinity, std::numeric_limits<float>::quiet_NaN(),
                                 1e30f,   -1e30f, 1e38f,    1e-38f,    1e-42f,
                                 -1e-45f, 1.0f,   -1.0f,    3e9f};
    const float sound = std::uniform_real_distribution(-2.0f, 2.0f)(random);
    switch (random() % 16) {
        case 0:
            return special[random() % std::size(special)];
        case 1:
            return std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        case 2:
            return std::ldexp(sound, static_cast<int>(random() % 40));
        case 3:
            return std::ldexp(sound, -static_cast<int>(random() % 60));
        default:
            return sound;
    }
}

TEST(Fuzz, OfTrianglesIsTheSameEverywhere) {
    const std::vector<gpu::Device> devices = open_every_device();
    std::mt19937 random{11};
    for (int round = 0; round < 24; ++round) {
        SCOPED_TRACE(round);
        render::Frame frame = flat_frame(1 + random() % 120, 1 + random() % 120, random() % 2 == 0 ? 1 : 4);
        frame.shading = static_cast<render::Shading>(random() % 7);
        frame.wires = random() % 4 == 0;
        frame.reflection.half_vector = random() % 2 == 0;
        frame.lights.resize(random() % 4);
        for (scene::Light& light : frame.lights) {
            light.kind = static_cast<scene::Light::Kind>(random() % 3);
            for (int axis = 0; axis < 3; ++axis)
                light.place[axis] = wild(random);
        }
        if (random() % 4 != 0) {
            frame.camera =
                render::frame_bounds({glm::vec3(-1.0f), glm::vec3(1.0f)},
                                     {wild(random), wild(random), 0.9f, random() % 2 == 0 ? 0.2f : 1.0f}, 1.0f);
        }
        scene::Material material;
        material.double_sided = random() % 2 == 0;
        material.alpha_mode = static_cast<scene::AlphaMode>(random() % 3);
        material.base_color = {0.8f, 0.3f, 0.1f, 0.6f};
        std::vector<Vertex> vertices(3 + random() % 60);
        for (Vertex& vertex : vertices) {
            for (float* at : {vertex.position, vertex.normal}) {
                for (int axis = 0; axis < 3; ++axis)
                    at[axis] = wild(random);
            }
            for (float& at : vertex.uv)
                at = wild(random);
        }
        std::vector<std::uint32_t> indices(3 * (1 + random() % 120));
        for (std::uint32_t& index : indices)
            index = random() % vertices.size();  // zero area among them
        std::vector<VertexAttributes> attributes(random() % 3 == 0 ? 0 : vertices.size());
        for (VertexAttributes& a : attributes) {
            for (float* at : {a.color, a.tangent}) {
                for (int i = 0; i < 4; ++i)
                    at[i] = wild(random);
            }
        }
        const image::Image expected = draw_portable(devices.front(), frame, vertices, indices, material, attributes);
        ASSERT_EQ(expected.rgba.size(), std::size_t{frame.width} * frame.height * 4);
        for (const gpu::Device& device : devices) {
            EXPECT_EQ(draw_portable(device, frame, vertices, indices, material, attributes).rgba, expected.rgba)
                << device.info().id;
        }
    }
}

TEST(Fuzz, OfTrianglesThatAreAllUnsoundDrawsNothing) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const render::Frame frame = flat_frame(30, 30, 4);
    for (const float bad : {nan, infinity, -infinity, 1e35f}) {
        std::vector<Vertex> vertices{place_vertex(frame, 0, 0), place_vertex(frame, 0, 7680),
                                     place_vertex(frame, 7680, 0)};
        const image::Image sound = draw_portable(open_device("reference"), frame, vertices, {0, 1, 2});
        EXPECT_NE(sound.rgba, std::vector<std::uint8_t>(sound.rgba.size(), 0));
        vertices[1].position[1] = bad;
        const image::Image picture = draw_portable(open_device("reference"), frame, vertices, {0, 1, 2});
        EXPECT_EQ(picture.rgba, std::vector<std::uint8_t>(picture.rgba.size(), 0)) << bad;
    }
}

}  // namespace
}  // namespace tessera::test
