// 8-bit RGBA images: PNG and JPEG in, PNG out, halving for mip levels, and differences for tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tessera::image {

/// The longest side that is read or written, in pixels.
inline constexpr std::uint32_t max_side = 16384;

/// Row-major, top row first, 4 bytes per pixel (R, G, B, A), sRGB encoded, alpha linear and not premultiplied.
struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgba;
};

/// Decodes PNG or JPEG from memory. `name` is used in errors. Refuses sides over max_side before allocating; throws
/// Error(usage) for anything that is not a sound image of either kind.
Image decode(std::span<const std::byte> bytes, const std::string& name);

/// Encodes a PNG in memory. Throws Error(output) for sides of 0 or over max_side.
std::vector<std::byte> encode_png(const Image& image);

/// Writes a PNG to a temporary file beside `path`, which is then renamed, so that `path` never holds half an image.
/// Throws Error(output).
void write_png(const Image& image, const std::filesystem::path& path);

/// The next mip level: sides halved, rounded down, at least 1. Each pixel is the mean of the (up to 3 x 3) pixels it
/// replaces, taken in linear light and weighted by alpha, so that hidden colours do not bleed into visible ones.
Image halve(const Image& image);

/// How far two images are apart, over all four channels, in 8-bit steps.
struct Difference {
    std::uint32_t max = 0;         ///< largest difference of one channel
    double mean = 0.0;             ///< over all channels of all pixels
    std::uint64_t count_over = 0;  ///< pixels in which a channel differs by more than the threshold
};

/// Compares two images pixel by pixel. Throws Error(usage) where their sizes differ.
Difference difference(const Image& a, const Image& b, std::uint32_t threshold = 0);

}  // namespace tessera::image
