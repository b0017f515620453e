#include "image/panels.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstring>
#include <iterator>

namespace tessera::image {
namespace {

void copy_into(Image& whole, const Image& part, std::uint32_t left, std::uint32_t top) {
    for (std::uint32_t y = 0; y < part.height; ++y) {
        std::memcpy(&whole.rgba[(std::size_t{top + y} * whole.width + left) * 4],
                    &part.rgba[std::size_t{y} * part.width * 4], std::size_t{part.width} * 4);
    }
}

}  // namespace

Image beside(const std::vector<Panel>& panels, const Rgba& paper) {
    if (panels.empty()) throw Error(ErrorKind::usage, "There are no pictures to put side by side.");
    const Image& first = panels.front().picture;
    const std::uint64_t width = std::uint64_t{first.width} * panels.size();
    if (width > max_side) {
        throw Error(ErrorKind::usage, fmt::format("{} pictures of {} pixels side by side are {} pixels wide, more than "
                                                  "{}; make them smaller.",
                                                  panels.size(), first.width, width, max_side));
    }
    std::vector<std::string> labels;
    std::ranges::transform(panels, std::back_inserter(labels), &Panel::label);
    const std::uint32_t scale = letter_scale(first.width, first.height, first.width * 15 / 16, labels);
    const std::uint32_t strip = 14 * scale;
    Image whole{static_cast<std::uint32_t>(width), std::min(first.height + strip, max_side), {}};
    whole.rgba.resize(std::size_t{whole.width} * whole.height * 4);
    fill_rectangle(whole, 0, first.height, whole.width, whole.height, paper);
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
