// A square that is shaded in every way, on every device, and its pixels.
#pragma once

#include "raster/portable.hpp"

#include <gtest/gtest.h>

#include <array>

namespace tessera::test {

/// Red, green, blue and alpha, 0 to 255.
using Pixel = std::array<int, 4>;

Pixel pixel_at(const image::Image& picture, std::uint32_t x, std::uint32_t y);

/// The 8-bit sRGB code of a linear value.
int code_of(double linear);

/// A square that fills a flat frame of 16 x 16 pixels, facing the viewer; u to the right and v down.
struct Square {
    render::Frame frame = flat_frame(16, 16, 1);
    std::vector<Vertex> vertices{place_vertex(frame, 0, 0), place_vertex(frame, 0, 4096),
                                 place_vertex(frame, 4096, 4096), place_vertex(frame, 4096, 0)};
    std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3};
    std::vector<VertexAttributes> attributes;  ///< none at first
    scene::Material material;
    std::vector<scene::SceneImage> images;

    /// Metallic-roughness under a black sky and without lights.
    Square();

    /// An image of one colour; gives its number.
    std::uint32_t add_image(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a = 255);

    /// One light straight ahead.
    void light_ahead(float intensity);

    /// Tangents for the material's normal map.
    void add_tangents();

    /// Draws on every device, expects the same bits, and returns the picture.
    image::Image draw() const;
};

}  // namespace tessera::test
