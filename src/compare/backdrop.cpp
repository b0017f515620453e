#include "compare/backdrop.hpp"

#include "image/srgb.hpp"

#include <cmath>

namespace tessera::compare {
namespace {

float decode(std::uint8_t encoded) {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = static_cast<float>(image::srgb_to_linear(static_cast<double>(i) / 255.0));
        }
        return values;
    }();
    return table[encoded];
}

float encode(float linear) {
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

}  // namespace

bool is_transparent(const image::Image& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
        if (image.rgba[i] != 255) return true;
    }
    return false;
}

Rgb linear_over(const std::uint8_t* rgba, Backdrop backdrop) {
    Rgb colour{decode(rgba[0]), decode(rgba[1]), decode(rgba[2])};
    if (rgba[3] != 255) {
        const float alpha = static_cast<float>(rgba[3]) / 255.0f;
        const float behind = backdrop == Backdrop::white ? 1.0f - alpha : 0.0f;
        for (float& channel : colour)
            channel = channel * alpha + behind;
    }
    return colour;
}

Rgb encoded_over(const std::uint8_t* rgba, Backdrop backdrop) {
    if (rgba[3] == 255) {
        return {static_cast<float>(rgba[0]) / 255.0f, static_cast<float>(rgba[1]) / 255.0f,
                static_cast<float>(rgba[2]) / 255.0f};
    }
    Rgb colour = linear_over(rgba, backdrop);
    for (float& channel : colour)
        channel = encode(channel);
    return colour;
}

}  // namespace tessera::compare
