#include "image/panels.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <stb/stb_easy_font.h>
#include <algorithm>
#include <cstring>

namespace tessera::image {
namespace {

/// A corner as stb_easy_font writes it; four make a rectangle.
struct Corner {
    float x, y, z;
    std::uint8_t colour[4];
};
static_assert(sizeof(Corner) == 16);

void fill(Image& image, std::int64_t left, std::int64_t top, std::int64_t right, std::int64_t bottom,
          const Rgba& colour) {
    const auto width = std::int64_t{image.width}, height = std::int64_t{image.height};
    for (std::int64_t y = std::clamp(top, std::int64_t{0}, height); y < std::min(bottom, height); ++y) {
        for (std::int64_t x = std::clamp(left, std::int64_t{0}, width); x < std::min(right, width); ++x)
            std::copy(colour.begin(), colour.end(), &image.rgba[static_cast<std::size_t>(y * width + x) * 4]);
    }
}

/// The library takes what it does not change as if it did, and has letters from space to tilde.
std::vector<char> writable(const std::string& text) {
    std::vector<char> words(text.begin(), text.end());
    std::replace_if(
        words.begin(), words.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    words.push_back('\0');
    return words;
}

void copy_into(Image& whole, const Image& part, std::uint32_t left, std::uint32_t top) {
    for (std::uint32_t y = 0; y < part.height; ++y) {
        std::memcpy(&whole.rgba[(std::size_t{top + y} * whole.width + left) * 4],
                    &part.rgba[std::size_t{y} * part.width * 4], std::size_t{part.width} * 4);
    }
}

}  // namespace

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
        fill(image, place(first.x, x), place(first.y, y), place(last.x, x), place(last.y, y), colour);
    }
}

std::uint32_t text_width(std::uint32_t scale, const std::string& text) {
    std::vector<char> words = writable(text);
    return static_cast<std::uint32_t>(stb_easy_font_width(words.data())) * scale;
}

Image beside(const std::vector<Panel>& panels, const Rgba& paper) {
    if (panels.empty()) throw Error(ErrorKind::usage, "There are no pictures to put side by side.");
    const Image& first = panels.front().picture;
    const std::uint64_t width = std::uint64_t{first.width} * panels.size();
    if (width > max_side) {
        throw Error(ErrorKind::usage, fmt::format("{} pictures of {} pixels side by side are {} pixels wide, more than "
                                                  "{}; make them smaller.",
                                                  panels.size(), first.width, width, max_side));
    }
    const std::uint32_t scale = std::clamp(std::min(first.width, first.height) / 200, 1u, 16u);
    const std::uint32_t strip = 14 * scale;
    Image whole{static_cast<std::uint32_t>(width), std::min(first.height + strip, max_side), {}};
    whole.rgba.resize(std::size_t{whole.width} * whole.height * 4);
    fill(whole, 0, first.height, whole.width, whole.height, paper);
    for (std::uint32_t i = 0; i < panels.size(); ++i) {
        const Panel& panel = panels[i];
        if (panel.picture.width != first.width || panel.picture.height != first.height) {
            throw Error(ErrorKind::usage,
                        fmt::format("Pictures of {} x {} and {} x {} pixels do not fit side by side.", first.width,
                                    first.height, panel.picture.width, panel.picture.height));
        }
        copy_into(whole, panel.picture, i * first.width, 0);
        const std::int64_t words = text_width(scale, panel.label);
        const std::int64_t left = std::int64_t{i} * first.width + (std::int64_t{first.width} - words) / 2;
        draw_text(whole, std::max(left, std::int64_t{i} * first.width), std::int64_t{first.height} + 3 * scale, scale,
                  panel.label, {60, 62, 66, 255});
    }
    return whole;
}

}  // namespace tessera::image
