// Plain text in an image.
#pragma once

#include "image/image.hpp"

#include <array>
#include <string_view>

namespace tessera::image {

/// Height of a line at scale 1, in pixels.
inline constexpr std::uint32_t text_height = 12;

/// Fills a rectangle, cut to the image.
void fill_rectangle(Image& image, int x, int y, int width, int height, std::array<std::uint8_t, 3> colour);

/// Writes ASCII text, opaque, with its top left corner at (x, y), `scale` pixels per dot of the letters. What lies
/// outside the image is cut off; other characters are left out.
void draw_text(Image& image, int x, int y, std::string_view text, std::array<std::uint8_t, 3> colour, int scale);

/// Width of text in pixels.
int text_width(std::string_view text, int scale);

}  // namespace tessera::image
