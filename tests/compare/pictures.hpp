// Pictures made by integer arithmetic, the same everywhere.
#pragma once

#include "image/image.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tessera::test {

using Colour = std::array<int, 4>;

template <typename ColourAt>
image::Image make_picture(std::uint32_t width, std::uint32_t height, const ColourAt& colour_at) {
    image::Image picture{width, height, {}};
    picture.rgba.reserve(std::size_t{width} * height * 4);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const Colour colour = colour_at(static_cast<int>(x), static_cast<int>(y));
            for (const int channel : colour)
                picture.rgba.push_back(static_cast<std::uint8_t>(std::clamp(channel, 0, 255)));
        }
    }
    return picture;
}

inline image::Image flat(std::uint32_t width, std::uint32_t height, const Colour& colour) {
    return make_picture(width, height, [&](int, int) { return colour; });
}

/// A number in [0, 255] that looks random.
inline int hash(int x, int y, int seed) {
    auto h = static_cast<std::uint32_t>(x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(y) * 0x85ebca77u ^
             static_cast<std::uint32_t>(seed) * 0xc2b2ae3du;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    h = (h ^ h >> 12) * 0x297a2d39u;
    return static_cast<int>((h ^ h >> 15) & 255u);
}

/// Gradients, a disc, a grid of thin lines and a coarse checker: smooth and sharp places, all hues. Opaque.
inline image::Image drawing(std::uint32_t width, std::uint32_t height, int shift = 0) {
    return make_picture(width, height, [&](int x, int y) -> Colour {
        x += shift;
        const int dx = x - static_cast<int>(width) / 2, dy = y - static_cast<int>(height) / 2;
        if (dx * dx + dy * dy < static_cast<int>(height * height) / 9) return {200 - dx, 60 + dy, 90, 255};
        if (x % 16 == 0 || y % 16 == 0) return {30, 40, 50, 255};
        if ((x / 32 + y / 32) % 2 == 0) return {x * 3 % 256, y * 2 % 256, 255 - x * 2 % 256, 255};
        return {240, 230 - y / 2, 80 + x / 2, 255};
    });
}

/// `picture` with noise of up to `strength` steps on every channel but alpha.
inline image::Image noisy(const image::Image& picture, int strength, int seed = 1) {
    return make_picture(picture.width, picture.height, [&](int x, int y) -> Colour {
        const std::uint8_t* p =
            &picture.rgba[(static_cast<std::size_t>(y) * picture.width + static_cast<std::size_t>(x)) * 4];
        const auto n = [&](int channel) { return (hash(x, y, seed * 3 + channel) - 128) * strength / 128; };
        return {p[0] + n(0), p[1] + n(1), p[2] + n(2), p[3]};
    });
}

/// The mean of the (2 * radius + 1)^2 pixels around each.
inline image::Image blurred(const image::Image& picture, int radius) {
    const int right = static_cast<int>(picture.width) - 1, bottom = static_cast<int>(picture.height) - 1;
    return make_picture(picture.width, picture.height, [&](int x, int y) {
        Colour sum{};
        for (int row = y - radius; row <= y + radius; ++row) {
            for (int column = x - radius; column <= x + radius; ++column) {
                const auto place = static_cast<std::size_t>(std::clamp(row, 0, bottom)) * picture.width +
                                   static_cast<std::size_t>(std::clamp(column, 0, right));
                for (std::size_t c = 0; c < 4; ++c)
                    sum[c] += picture.rgba[place * 4 + c];
            }
        }
        const int count = (2 * radius + 1) * (2 * radius + 1);
        for (int& channel : sum)
            channel = (channel + count / 2) / count;
        return sum;
    });
}

}  // namespace tessera::test
