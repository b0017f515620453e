#include "image/panels.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstring>

namespace tessera::image {
namespace {

void copy_into(Image& whole, const Image& part, std::uint32_t left, std::uint32_t top) {
    for (std::uint32_t y = 0; y < part.height; ++y) {
        std::memcpy(&whole.rgba[(std::size_t{top + y} * whole.width + left) * 4],
                    &part.rgba[std::size_t{y} * part.width * 4], std::size_t{part.width} * 4);
    }
}

std::vector<std::string> lines_of(const std::string& label) {
    std::vector<std::string> lines;
    std::size_t at = 0;
    while (at <= label.size()) {
        const std::size_t end = std::min(label.find('\n', at), label.size());
        lines.push_back(label.substr(at, end - at));
        at = end + 1;
    }
    return lines;
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
    std::size_t lines = 1;
    std::vector<std::string> all;
    for (const Panel& panel : panels) {
        const std::vector<std::string> own = lines_of(panel.label);
        lines = std::max(lines, own.size());
        all.insert(all.end(), own.begin(), own.end());
    }
    const std::uint32_t scale = letter_scale(first.width, first.height, first.width * 15 / 16, all);
    const std::uint32_t strip = (2 + 12 * static_cast<std::uint32_t>(lines)) * scale;
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
        std::int64_t top = std::int64_t{first.height} + 3 * scale;
        for (const std::string& line : lines_of(panel.label)) {
            const std::int64_t left = (std::int64_t{first.width} - text_width(scale, line)) / 2;
            draw_text(whole, std::int64_t{i} * first.width + std::max<std::int64_t>(left, 0), top, scale, line,
                      {60, 62, 66, 255});
            top += 12 * scale;
        }
    }
    return whole;
}

}  // namespace tessera::image
