#include "image/text.hpp"

#include <algorithm>
#include <string>
#include <vector>

// Letters as rectangles. Its warnings are not ours to mend.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#include <stb/stb_easy_font.h>
#pragma GCC diagnostic pop

namespace tessera::image {
namespace {

std::string ascii(std::string_view text) {
    std::string result;
    std::ranges::copy_if(text, std::back_inserter(result), [](char c) { return c >= 32 && c < 127; });
    return result;
}

}  // namespace

void fill_rectangle(Image& image, int x, int y, int width, int height, std::array<std::uint8_t, 3> colour) {
    const int right = std::min(x + width, static_cast<int>(image.width));
    const int bottom = std::min(y + height, static_cast<int>(image.height));
    for (int row = std::max(y, 0); row < bottom; ++row) {
        for (int column = std::max(x, 0); column < right; ++column) {
            std::uint8_t* pixel = image.rgba.data() +
                                  (static_cast<std::size_t>(row) * image.width + static_cast<std::size_t>(column)) * 4;
            std::copy(colour.begin(), colour.end(), pixel);
            pixel[3] = 255;
        }
    }
}

void draw_text(Image& image, int x, int y, std::string_view text, std::array<std::uint8_t, 3> colour, int scale) {
    struct Corner {
        float x, y, z;
        std::uint32_t colour;
    };
    std::string words = ascii(text);
    std::vector<Corner> corners(words.size() * 80 + 4);  // a letter has at most 20 rectangles of four corners
    const int quads = stb_easy_font_print(0.0f, 0.0f, words.data(), nullptr, corners.data(),
                                          static_cast<int>(corners.size() * sizeof(Corner)));
    for (int q = 0; q < quads; ++q) {
        const Corner& first = corners[4 * static_cast<std::size_t>(q)];
        const Corner& opposite = corners[4 * static_cast<std::size_t>(q) + 2];
        fill_rectangle(image, x + static_cast<int>(first.x) * scale, y + static_cast<int>(first.y) * scale,
                       static_cast<int>(opposite.x - first.x) * scale, static_cast<int>(opposite.y - first.y) * scale,
                       colour);
    }
}

int text_width(std::string_view text, int scale) {
    std::string words = ascii(text);
    return stb_easy_font_width(words.data()) * scale;
}

}  // namespace tessera::image
