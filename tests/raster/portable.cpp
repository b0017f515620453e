#include "raster/portable.hpp"

#include "raster/portable_rasteriser.hpp"

#include <gtest/gtest.h>

namespace tessera::test {

render::Frame flat_frame(std::uint32_t width, std::uint32_t height, std::uint32_t samples) {
    render::Frame frame;
    frame.width = width;
    frame.height = height;
    frame.samples = samples;
    frame.background = glm::vec4(0.0f);
    frame.shading = render::Shading::normals;
    glm::mat4& projection = frame.camera.projection;
    projection = glm::mat4(0.0f);
    projection[0][0] = 1.0f;
    projection[1][1] = -1.0f;
    projection[2][2] = -0.5f;
    projection[3][2] = 0.5f;
    projection[3][3] = 1.0f;
    return frame;
}

Vertex place_vertex(const render::Frame& frame, int x, int y, float z) {
    const auto at = [](int place, std::uint32_t pixels) { return static_cast<float>(place / (128.0 * pixels) - 1.0); };
    return {{at(x, frame.width), -at(y, frame.height), z}, {0, 0, 1}, {0, 0}};
}

image::Image draw_portable(const gpu::Device& device, const render::Frame& frame, const std::vector<Vertex>& vertices,
                           const std::vector<std::uint32_t>& indices, const scene::Material& material,
                           const std::vector<VertexAttributes>& attributes) {
    const auto rasteriser = raster::open_portable(device);
    rasteriser->begin(frame);
    rasteriser->set_materials({material}, {});
    rasteriser->draw(render::Draw{vertices, indices, 0, attributes});
    return rasteriser->finish();
}

std::vector<int> coverage_counts(const gpu::Device& device, const render::Frame& frame,
                                 const std::vector<Vertex>& vertices, const std::vector<std::uint32_t>& indices) {
    EXPECT_EQ(frame.samples, 1u);
    scene::Material glass;
    glass.base_color.a = 0.5f;
    glass.alpha_mode = scene::AlphaMode::blend;
    glass.double_sided = true;
    const image::Image picture = draw_portable(device, frame, vertices, indices, glass);
    std::vector<int> counts;
    for (std::size_t at = 3; at < picture.rgba.size(); at += 4) {
        const int alpha = picture.rgba[at];
        int count = 0;
        for (int through = 255; count < 6 && alpha > 255 - through + 2; through /= 2) {
            ++count;
        }
        counts.push_back(count);
    }
    return counts;
}

}  // namespace tessera::test
