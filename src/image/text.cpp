#include "image/text.hpp"

// Letters as rectangles. Its warnings are not ours to mend.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#include <stb/stb_easy_font.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <vector>

namespace tessera::image {
namespace {

/// A corner as stb_easy_font writes it; four make a rectangle.
struct Corner {
    float x, y, z;
    std::uint8_t colour[4];
};
static_assert(sizeof(Corner) == 16);

/// The library takes what it does not change as if it did, and has letters from space to tilde.
std::vector<char> writable(const std::string& text) {
    std::vector<char> words(text.begin(), text.end());
    std::replace_if(
        words.begin(), words.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    words.push_back('\0');
    return words;
}

}  // namespace

void fill_rectangle(Image& image, std::int64_t left, std::int64_t top, std::int64_t right, std::int64_t bottom,
                    const Rgba& colour) {
    const auto width = std::int64_t{image.width}, height = std::int64_t{image.height};
    for (std::int64_t y = std::clamp(top, std::int64_t{0}, height); y < std::min(bottom, height); ++y) {
        for (std::int64_t x = std::clamp(left, std::int64_t{0}, width); x < std::min(right, width); ++x)
            std::copy(colour.begin(), colour.end(), &image.rgba[static_cast<std::size_t>(y * width + x) * 4]);
    }
}

void draw_text(Image& image, std::int64_t x, std::int64_t y, std::uint32_t scale, const std::string& text,
               const Rgba& colour) {
    // At most 270 bytes a letter, as the library's documentation has it.
    std::vector<Corner> corners((text.size() + 1) * 24);
    std::vector<char> words = writable(text);
    const int rectangles = stb_easy_font_print(0.0f, 0.0f, words.data(), nullptr, corners.data(),
                                               static_cast<int>(corners.size() * sizeof(Corner)));
    for (std::size_t i = 0; i < static_cast<std::size_t>(rectangles); ++i) {
        const Corner& first = corners[i * 4];
        const Corner& last = corners[i * 4 + 2];
        const auto place = [&](float at, std::int64_t start) {
            return start + static_cast<std::int64_t>(at) * std::int64_t{scale};
        };
        fill_rectangle(image, place(first.x, x), place(first.y, y), place(last.x, x), place(last.y, y), colour);
    }
}

std::uint32_t text_width(std::uint32_t scale, const std::string& text) {
    std::vector<char> words = writable(text);
    return static_cast<std::uint32_t>(stb_easy_font_width(words.data())) * scale;
}

std::uint32_t letter_scale(std::uint32_t width, std::uint32_t height, std::uint32_t widest,
                           const std::vector<std::string>& lines) {
    std::uint32_t scale = std::clamp(std::min(width, height) / 200, 1u, 16u);
    for (const std::string& line : lines) {
        while (scale > 1 && text_width(scale, line) > widest)
            --scale;
    }
    return scale;
}

}  // namespace tessera::image
