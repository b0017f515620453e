#include "views/colour_bar.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

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
    const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(length))), 0, 12);
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

void append_colour_bar(image::Image& picture, const PanelSize& panel, const Scale& scale, const std::string& title,
                       const image::Rgba& paper) {
    const std::uint32_t text = image::letter_scale(panel.width, panel.height, picture.width * 15 / 16, {title});
    const std::int64_t s = text;
    const std::int64_t top = append_strip(picture, 38 * s, paper);
    const std::int64_t middle = picture.width / 2;
    image::draw_text(picture, middle - image::text_width(text, title) / 2, top + 4 * s, text, title, ink);

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
    std::string all;
    for (const Key& key : keys)
        all += "------" + key.words;
    const std::uint32_t text = image::letter_scale(panel.width, panel.height, picture.width * 15 / 16, {all});
    const std::int64_t s = text;
    const std::int64_t top = append_strip(picture, 14 * s, paper);
    constexpr std::int64_t line = 16, gap = 5, apart = 18;
    std::int64_t width = -apart * s;
    for (const Key& key : keys)
        width += (line + gap + apart) * s + image::text_width(text, key.words);
    std::int64_t x = (std::int64_t{picture.width} - width) / 2;
    for (const Key& key : keys) {
        image::fill_rectangle(picture, x, top + 6 * s, x + line * s, top + 8 * s, key.colour);
        x += (line + gap) * s;
        image::draw_text(picture, x, top + 4 * s, text, key.words, ink);
        x += image::text_width(text, key.words) + apart * s;
    }
}

}  // namespace tessera::views
