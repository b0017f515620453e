#include "raster/srgb_tables.hpp"

#include "image/srgb.hpp"
#include "raster/raster_layout.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tessera::raster {
namespace {

std::uint32_t bits(double value) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(value));
}

/// Where entry `i` of the encoding table begins.
double entry_start(std::uint32_t i) {
    return std::bit_cast<float>(0x39000000u + (i << 20u));
}

}  // namespace

std::uint32_t encode_srgb(double linear) {
    return static_cast<std::uint32_t>(std::lround(image::linear_to_srgb(std::clamp(linear, 0.0, 1.0)) * 255.0));
}

std::vector<std::uint32_t> make_srgb_tables() {
    std::vector<std::uint32_t> words(LOOK_AT);
    for (std::uint32_t code = 0; code < 256; ++code) {
        words[SRGB_DECODE_AT + code] = bits(image::srgb_to_linear(code / 255.0));
    }
    for (std::uint32_t i = 0; i < SRGB_ENCODE_ENTRIES; ++i) {
        const double from = entry_start(i);
        const double to = entry_start(i + 1);
        const double low = image::linear_to_srgb(from) * 255.0;
        const double slope = (image::linear_to_srgb(to) * 255.0 - low) / (to - from);
        // The chord lies under the curve: half of its largest distance up, the error is the same on both sides.
        const double middle = (from + to) / 2.0;
        const double below = image::linear_to_srgb(middle) * 255.0 - (low + slope * (middle - from));
        words[SRGB_ENCODE_AT + 2 * i] = bits(low + below / 2.0);
        words[SRGB_ENCODE_AT + 2 * i + 1] = bits(slope);
    }
    return words;
}

}  // namespace tessera::raster
