// Words and rectangles on an image.
#pragma once

#include "image/image.hpp"

#include <array>
#include <string>
#include <vector>

namespace tessera::image {

using Rgba = std::array<std::uint8_t, 4>;

/// Fills [left, right) x [top, bottom), cut to the image.
void fill_rectangle(Image& image, std::int64_t left, std::int64_t top, std::int64_t right, std::int64_t bottom,
                    const Rgba& colour);

/// Writes text with its upper left corner at (x, y), in letters of 5 x 7 pixels or so (stb_easy_font) times
/// `scale`. What lies outside the image is cut off; what is not ASCII becomes a question mark.
void draw_text(Image& image, std::int64_t x, std::int64_t y, std::uint32_t scale, const std::string& text,
               const Rgba& colour);

/// How wide draw_text() would make a line.
std::uint32_t text_width(std::uint32_t scale, const std::string& text);

/// The scale of letters that suit pictures of this size, 1 to 16, but not wider than `widest` pixels in any of `lines`.
std::uint32_t letter_scale(std::uint32_t width, std::uint32_t height, std::uint32_t widest,
                           const std::vector<std::string>& lines);

}  // namespace tessera::image
