// Arithmetic on pixels: halving and differences.
#include "base/error.hpp"
#include "image/image.hpp"

#include "image/srgb.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

namespace tessera::image {

namespace {

/// Decodes an sRGB value in [0, 255] that may lie between two steps.
double decode_srgb(double step) {
    return srgb_to_linear(step / 255.0);
}

float to_linear(std::uint8_t encoded) {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = static_cast<float>(decode_srgb(static_cast<double>(i)));
        }
        return values;
    }();
    return table[encoded];
}

/// The nearest step: counts the half steps that lie below.
std::uint8_t to_srgb(float linear) {
    static const std::array<float, 255> half_steps = [] {
        std::array<float, 255> values{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = static_cast<float>(decode_srgb(static_cast<double>(i) + 0.5));
        }
        return values;
    }();
    return static_cast<std::uint8_t>(std::upper_bound(half_steps.begin(), half_steps.end(), linear) -
                                     half_steps.begin());
}

/// The pixels [first, last) of a side of `size` that pixel `i` of `half` pixels replaces: two, or three at the end
/// of an odd side.
struct Run {
    std::uint32_t first, last;
};
Run covered(std::uint32_t i, std::uint32_t half, std::uint32_t size) {
    return {std::min(2 * i, size - 1), i + 1 == half ? size : 2 * i + 2};
}

}  // namespace

Image halve(const Image& image) {
    Image half{std::max(image.width / 2, 1u), std::max(image.height / 2, 1u), {}};
    half.rgba.resize(std::size_t{half.width} * half.height * 4);
    std::uint8_t* out = half.rgba.data();
    for (std::uint32_t y = 0; y < half.height; ++y) {
        const Run rows = covered(y, half.height, image.height);
        for (std::uint32_t x = 0; x < half.width; ++x, out += 4) {
            const Run columns = covered(x, half.width, image.width);
            std::array<float, 3> visible{};
            std::array<float, 3> plain{};
            float alpha = 0.0f;
            for (std::uint32_t row = rows.first; row < rows.last; ++row) {
                for (std::uint32_t column = columns.first; column < columns.last; ++column) {
                    const std::uint8_t* in = &image.rgba[(std::size_t{row} * image.width + column) * 4];
                    alpha += in[3];
                    for (std::size_t c = 0; c < 3; ++c) {
                        visible[c] += to_linear(in[c]) * in[3];
                        plain[c] += to_linear(in[c]);
                    }
                }
            }
            const auto count = static_cast<float>((rows.last - rows.first) * (columns.last - columns.first));
            for (std::size_t c = 0; c < 3; ++c) {
                out[c] = to_srgb(alpha > 0.0f ? visible[c] / alpha : plain[c] / count);
            }
            out[3] = static_cast<std::uint8_t>(std::lround(alpha / count));
        }
    }
    return half;
}

Difference difference(const Image& a, const Image& b, std::uint32_t threshold) {
    if (a.width != b.width || a.height != b.height || a.rgba.size() != b.rgba.size()) {
        throw Error(ErrorKind::usage, fmt::format("Images of {} x {} and {} x {} pixels cannot be compared.", a.width,
                                                  a.height, b.width, b.height));
    }
    Difference result;
    std::uint64_t sum = 0;
    for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
        std::uint32_t largest = 0;
        for (std::size_t i = pixel; i < pixel + 4; ++i) {
            const auto apart = static_cast<std::uint32_t>(std::abs(int{a.rgba[i]} - int{b.rgba[i]}));
            largest = std::max(largest, apart);
            sum += apart;
        }
        result.max = std::max(result.max, largest);
        result.count_over += largest > threshold ? 1 : 0;
    }
    result.mean = a.rgba.empty() ? 0.0 : static_cast<double>(sum) / static_cast<double>(a.rgba.size());
    return result;
}

}  // namespace tessera::image
