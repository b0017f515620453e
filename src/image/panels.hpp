// Pictures side by side, and words on them.
#pragma once

#include "image/image.hpp"

#include <array>

namespace tessera::image {

using Rgba = std::array<std::uint8_t, 4>;

/// Writes text with its upper left corner at (x, y), in letters of 5 x 7 pixels or so (stb_easy_font) times
/// `scale`. What lies outside the image is cut off; what is not ASCII becomes a question mark.
void draw_text(Image& image, std::int64_t x, std::int64_t y, std::uint32_t scale, const std::string& text,
               const Rgba& colour);

/// How wide draw_text() would make a line.
std::uint32_t text_width(std::uint32_t scale, const std::string& text);

struct Panel {
    Image picture;
    std::string label;
};

/// Pictures of one size side by side, each over its label on a strip of `paper`. Throws Error(usage) where there
/// is none, sizes differ, or the result would be longer than max_side.
Image beside(const std::vector<Panel>& panels, const Rgba& paper);

}  // namespace tessera::image
