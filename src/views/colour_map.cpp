#include "views/colour_map.hpp"

#include "image/srgb.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tessera::views {
namespace {

constexpr std::array<std::array<std::uint8_t, 3>, 10> anchors{{{0x44, 0x01, 0x54},
                                                               {0x48, 0x28, 0x78},
                                                               {0x3e, 0x49, 0x89},
                                                               {0x31, 0x68, 0x8e},
                                                               {0x26, 0x82, 0x8e},
                                                               {0x1f, 0x9e, 0x89},
                                                               {0x35, 0xb7, 0x79},
                                                               {0x6d, 0xcd, 0x59},
                                                               {0xb4, 0xde, 0x2c},
                                                               {0xfd, 0xe7, 0x25}}};

// Texels are few, a texel for each colour, so that mip levels, which would mix far colours, come into play as late as
// can be: triangles thinner than a pixel ask for them.
constexpr std::uint32_t texture_width = 16, first_texel = 3;

double linear_light(std::uint8_t code) {
    return image::srgb_to_linear(code / 255.0);
}

std::uint8_t srgb_code(double light) {
    return static_cast<std::uint8_t>(std::lround(255.0 * image::linear_to_srgb(light)));
}

}  // namespace

double Scale::place(double value) const {
    const double length = greatest - least;
    if (std::isnan(value)) return 0.0;
    return length > 0.0 ? std::clamp((value - least) / length, 0.0, 1.0) : 0.5;
}

image::Rgba map_colour(double place) {
    const double at = std::clamp(place, 0.0, 1.0) * (anchors.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), anchors.size() - 2);
    const double share = at - static_cast<double>(below);
    image::Rgba colour{0, 0, 0, 255};
    for (std::size_t c = 0; c < 3; ++c) {
        colour[c] =
            srgb_code((1.0 - share) * linear_light(anchors[below][c]) + share * linear_light(anchors[below + 1][c]));
    }
    return colour;
}

scene::SceneImage map_texture() {
    scene::SceneImage texture;
    texture.name = "colour map";
    texture.pixels = {texture_width, 1, {}};
    for (std::uint32_t x = 0; x < texture_width; ++x) {
        const image::Rgba colour = map_colour((static_cast<double>(x) - first_texel) / (anchors.size() - 1));
        texture.pixels.rgba.insert(texture.pixels.rgba.end(), colour.begin(), colour.end());
    }
    return texture;
}

float map_u(double place) {
    return static_cast<float>((first_texel + 0.5 + std::clamp(place, 0.0, 1.0) * (anchors.size() - 1)) / texture_width);
}

}  // namespace tessera::views
