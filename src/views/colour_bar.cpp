#include "views/colour_bar.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>

namespace tessera::views {
namespace {

constexpr image::Rgba ink{60, 62, 66, 255};

/// Adds rows of `paper`; returns the first of them.
std::int64_t append_strip(image::Image& picture, std::int64_t height, const image::Rgba& paper) {
    const std::int64_t top = picture.height;
    picture.height += static_cast<std::uint32_t>(height);
    picture.rgba.resize(std::size_t{picture.width} * picture.height * 4);
    image::fill_rectangle(picture, 0, top, picture.width, picture.height, paper);
    return top;
}

/// The title, in two lines at its comma where one is too wide for letters of the usual size.
std::vector<std::string> title_lines(const std::string& title, const PanelSize& panel, std::uint32_t room) {
    const std::size_t comma = title.find(", ");
    const std::uint32_t usual = image::letter_scale(panel.width, panel.height, 0, {});
    if (comma == std::string::npos || image::text_width(usual, title) <= room) return {title};
    return {title.substr(0, comma + 1), title.substr(comma + 2)};
}

double tick_step(const Scale& scale, int wanted) {
    const double rough = (scale.greatest - scale.least) / wanted;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * power >= rough * 0.999) return step * power;
    }
    return 10.0 * power;
}

}  // namespace

std::vector<double> bar_ticks(const Scale& scale, int wanted) {
    if (!(scale.greatest > scale.least)) return {scale.least};
    std::vector<double> ticks{scale.least};
    const double step = tick_step(scale, wanted);
    for (double k = std::ceil(scale.least / step); k * step < scale.greatest; k += 1.0) {
        const double tick = k * step;
        if (tick > scale.least) ticks.push_back(tick);
    }
    ticks.push_back(scale.greatest);
    return ticks;
}

std::string tick_text(double value, const Scale& scale) {
    const double length = scale.greatest - scale.least;
    if (!(length > 0.0)) return fmt::format("{:.4g}", value);
    // Three digits of the scale's length.
    const int decimals = std::max(2 - static_cast<int>(std::floor(std::log10(length))), 0);
    if (decimals > 6) return fmt::format("{:.3g}", value);
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

void append_colour_bar(image::Image& picture, const PanelSize& panel, const Scale& scale, const std::string& title,
                       const image::Rgba& paper) {
    const std::uint32_t room = picture.width * 15 / 16;
    const std::vector<std::string> lines = title_lines(title, panel, room);
    const std::uint32_t text = image::letter_scale(panel.width, panel.height, room, lines);
    const std::int64_t s = text;
    const std::int64_t more = 10 * s * (std::ssize(lines) - 1);
    const std::int64_t first = append_strip(picture, 38 * s + more, paper), top = first + more;
    const std::int64_t middle = picture.width / 2;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        image::draw_text(picture, middle - image::text_width(text, lines[i]) / 2,
                         first + (4 + 10 * static_cast<std::int64_t>(i)) * s, text, lines[i], ink);
    }

    const std::int64_t width = std::min<std::int64_t>(240 * s, std::int64_t{picture.width} * 8 / 10);
    const std::int64_t left = middle - width / 2, bar = top + 14 * s, under = bar + 8 * s;
    for (std::int64_t x = 0; x < width; ++x) {
        const double value =
            scale.least + (scale.greatest - scale.least) * (static_cast<double>(x) + 0.5) / static_cast<double>(width);
        image::fill_rectangle(picture, left + x, bar, left + x + 1, under, map_colour(scale.place(value)));
    }
    std::vector<double> ticks = bar_ticks(scale, 6);
    // The ends first: they are written in any case.
    std::rotate(ticks.begin(), ticks.end() - 1, ticks.end());
    std::vector<std::pair<std::int64_t, std::int64_t>> taken;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const std::int64_t at =
            left + std::min<std::int64_t>(width - 1, std::llround(scale.place(ticks[i]) * static_cast<double>(width)));
        const std::string words = tick_text(ticks[i], scale);
        const std::int64_t half = image::text_width(text, words) / 2;
        const bool touches = std::ranges::any_of(taken, [&](const auto& other) {
            return at - half - 4 * s < other.second && at + half + 4 * s > other.first;
        });
        if (i >= 2 && touches) continue;
        taken.emplace_back(at - half, at + half);
        image::fill_rectangle(picture, at - s / 2, under, at - s / 2 + std::max<std::int64_t>(s / 2, 1), under + 2 * s,
                              ink);
        image::draw_text(picture, at - half, under + 4 * s, text, words, ink);
    }
}

void append_keys(image::Image& picture, const PanelSize& panel, const std::vector<Key>& keys,
                 const image::Rgba& paper) {
    constexpr std::uint32_t line = 16, gap = 5, apart = 18;
    const auto width_of = [&](const Key& key, std::uint32_t scale) {
        return (line + gap) * scale + image::text_width(scale, key.words);
    };
    const auto width_of_all = [&](std::uint32_t scale) {
        std::uint32_t width = apart * scale * static_cast<std::uint32_t>(keys.size() - 1);
        for (const Key& key : keys)
            width += width_of(key, scale);
        return width;
    };
    std::uint32_t text = image::letter_scale(panel.width, panel.height, 0, {});
    while (text > 1 && width_of_all(text) > picture.width)
        --text;
    const bool beneath = width_of_all(text) > picture.width;  // each other
    const std::int64_t s = text;
    std::int64_t y = append_strip(picture, (4 + 10 * (beneath ? std::ssize(keys) : 1)) * s, paper) + 4 * s;
    std::int64_t x = (std::int64_t{picture.width} - width_of_all(text)) / 2;
    for (const Key& key : keys) {
        if (beneath) x = (std::int64_t{picture.width} - width_of(key, text)) / 2;
        image::fill_rectangle(picture, x, y + 2 * s, x + line * s, y + 4 * s, key.colour);
        image::draw_text(picture, x + (line + gap) * s, y, text, key.words, ink);
        x += width_of(key, text) + apart * s;
        y += beneath ? 10 * s : 0;
    }
}

}  // namespace tessera::views
