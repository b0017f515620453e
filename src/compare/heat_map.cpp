#include "compare/heat_map.hpp"

#include "compare/tiles.hpp"

#include <array>
#include <cmath>

namespace tessera::compare {
namespace {

// Ten colours at even steps; between them it is mixed.
constexpr std::array<std::array<std::uint8_t, 3>, 10> anchors{{{0x00, 0x00, 0x04},
                                                               {0x18, 0x0f, 0x3e},
                                                               {0x45, 0x10, 0x77},
                                                               {0x72, 0x1f, 0x81},
                                                               {0x9f, 0x2f, 0x7f},
                                                               {0xcd, 0x40, 0x71},
                                                               {0xf1, 0x60, 0x5d},
                                                               {0xfd, 0x95, 0x67},
                                                               {0xfe, 0xca, 0x8d},
                                                               {0xfc, 0xfd, 0xbf}}};

}  // namespace

std::array<std::uint8_t, 3> heat_colour(float error) {
    if (std::isnan(error)) return {255, 255, 255};
    const float place = std::clamp(error, 0.0f, 1.0f) * static_cast<float>(anchors.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
    const float share = place - static_cast<float>(below);
    std::array<std::uint8_t, 3> colour{};
    for (std::size_t c = 0; c < 3; ++c) {
        const float mixed = (1.0f - share) * anchors[below][c] + share * anchors[below + 1][c];
        colour[c] = static_cast<std::uint8_t>(std::lround(mixed));
    }
    return colour;
}

image::Image heat_map(std::span<const float> errors, std::uint32_t width, std::uint32_t height) {
    image::Image picture{width, height, {}};
    picture.rgba.resize(errors.size() * 4);
    for_each_tile(width, height, [&](std::size_t, const Tile& tile) {
        for (std::int64_t y = tile.y; y < tile.y + tile.height; ++y) {
            for (std::int64_t x = tile.x; x < tile.x + tile.width; ++x) {
                const auto pixel = static_cast<std::size_t>(y * width + x);
                const auto colour = heat_colour(errors[pixel]);
                std::copy(colour.begin(), colour.end(), &picture.rgba[pixel * 4]);
                picture.rgba[pixel * 4 + 3] = 255;
            }
        }
    });
    return picture;
}

}  // namespace tessera::compare
