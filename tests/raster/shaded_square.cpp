#include "raster/shaded_square.hpp"

#include "patches/mikktspace.hpp"
#include "raster/portable_rasteriser.hpp"
#include "support/devices.hpp"

#include <algorithm>
#include <cmath>

namespace tessera::test {

Pixel pixel_at(const image::Image& picture, std::uint32_t x, std::uint32_t y) {
    const std::uint8_t* p = &picture.rgba[(std::size_t{y} * picture.width + x) * 4];
    return {p[0], p[1], p[2], p[3]};
}

int code_of(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    return static_cast<int>(std::lround(255.0 * (x <= 0.0031308 ? x * 12.92 : 1.055 * std::pow(x, 1 / 2.4) - 0.055)));
}

Square::Square() {
    vertices[1].uv[1] = vertices[2].uv[1] = vertices[2].uv[0] = vertices[3].uv[0] = 1.0f;
    for (Vertex& vertex : vertices)
        vertex.position[2] = -3.0f;
    frame.camera.projection[2][2] = -0.1f;  // depths of 0 to 10
    frame.camera.projection[3][2] = 0.0f;
    frame.shading = render::Shading::pbr;
    frame.sky = {glm::vec3(0.0f), glm::vec3(0.0f), glm::vec3(0.0f)};
}

std::uint32_t Square::add_image(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a) {
    scene::SceneImage image;
    image.pixels = {4, 4, {}};
    for (int i = 0; i < 16; ++i)
        image.pixels.rgba.insert(image.pixels.rgba.end(), {r, g, b, a});
    images.push_back(std::move(image));
    return static_cast<std::uint32_t>(images.size() - 1);
}

void Square::light_ahead(float intensity) {
    scene::Light light;
    light.intensity = glm::vec3(intensity);
    frame.lights = {light};
}

void Square::add_tangents() {
    const std::vector<patches::PatchCorners> faces{{0, 1, 2, 3}};
    const auto tangents = patches::corner_tangents(vertices, faces, material.maps.normal->transform);
    attributes.resize(4);
    for (std::size_t i = 0; i < 4; ++i) {
        for (int k = 0; k < 4; ++k)
            attributes[i].tangent[k] = tangents[0][i][k];
    }
}

image::Image Square::draw() const {
    std::optional<image::Image> first;
    for (const gpu::Device& device : open_every_device()) {
        const auto rasteriser = raster::open_portable(device);
        rasteriser->begin(frame);
        rasteriser->set_materials({material}, images);
        rasteriser->draw(render::Draw{vertices, indices, 0, attributes});
        const image::Image picture = rasteriser->finish();
        if (!first) first = picture;
        EXPECT_EQ(picture.rgba, first->rgba) << device.info().id;
    }
    return *first;
}

}  // namespace tessera::test
