#include "bench/plot.hpp"

#include "image/text.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <iterator>

namespace tessera::bench {
namespace {

using Colour = image::Rgba;

constexpr Colour ink{34, 34, 34, 255};
constexpr Colour ours{31, 78, 121, 255};
constexpr Colour peers{170, 170, 170, 255};
constexpr int width = 1000;
constexpr int left = 330;   // where bars begin
constexpr int right = 120;  // room for the number behind the longest
constexpr int bar = 22;     // from one bar to the next
constexpr int heading_height = 40;

struct Rectangle {
    int x, y, width, height;
    Colour colour;
};
struct Text {
    int x, y;  // top left, or top right where it ends there
    bool ends;
    std::string words;
};
struct Drawing {
    int height = 0;
    std::vector<Rectangle> rectangles;
    std::vector<Text> texts;
};

Drawing draw(const Report& report) {
    Drawing d;
    int y = 16;
    d.texts.push_back({16, y, false, "Millions of triangles per second, whole jobs, medians; grey: peers"});
    y += heading_height;
    for (const auto& [id, description] : report.workloads) {
        std::vector<std::pair<const Figure*, double>> bars;
        for (const Figure& figure : report.figures) {
            if (figure.workload == id && figure.rejected.empty() && figure.triangles > 0) {
                bars.emplace_back(&figure, static_cast<double>(figure.triangles) / figure.seconds.median * 1e-6);
            }
        }
        if (bars.empty()) continue;
        const double longest = std::ranges::max_element(bars, {}, [](const auto& b) { return b.second; })->second;
        d.texts.push_back({16, y, false, fmt::format("{}: {}", id, description)});
        y += 24;
        for (const auto& [figure, rate] : bars) {
            const int length = std::max(static_cast<int>((width - left - right) * rate / longest), 1);
            d.texts.push_back({left - 10, y + 3, true, figure->contestant});
            d.rectangles.push_back({left, y, length, bar - 6, figure->peer ? peers : ours});
            d.texts.push_back({left + length + 8, y + 3, false, fmt::format("{:.4g}", rate)});
            y += bar;
        }
        y += 20;
    }
    d.height = y + 10;
    return d;
}

std::string hex(Colour c) {
    return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]);
}

std::string xml_text(const std::string& text) {
    std::string result;
    for (const char c : text) {
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    }
    return result;
}

}  // namespace

std::string plot_svg(const Report& report) {
    const Drawing d = draw(report);
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"sans-serif\" font-size=\"14\" fill=\"{2}\">\n<rect width=\"{0}\" height=\"{1}\" "
        "fill=\"#fff\"/>\n",
        width, d.height, hex(ink));
    for (const Rectangle& r : d.rectangles) {
        fmt::format_to(std::back_inserter(svg), "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                       r.x, r.y, r.width, r.height, hex(r.colour));
    }
    for (const Text& t : d.texts) {
        fmt::format_to(std::back_inserter(svg), "<text x=\"{}\" y=\"{}\"{}>{}</text>\n", t.x, t.y + 10,
                       t.ends ? " text-anchor=\"end\"" : "", xml_text(t.words));
    }
    return svg + "</svg>\n";
}

image::Image plot_image(const Report& report) {
    const Drawing d = draw(report);
    constexpr int scale = 2;  // so that letters, of one size only, do not look coarse
    image::Image image;
    image.width = width * scale;
    image.height = static_cast<std::uint32_t>(d.height * scale);
    image.rgba.assign(std::size_t{image.width} * image.height * 4, 255);
    for (const Rectangle& r : d.rectangles) {
        image::fill_rectangle(image, r.x * scale, r.y * scale, (r.x + r.width) * scale, (r.y + r.height) * scale,
                              r.colour);
    }
    for (const Text& t : d.texts) {
        const std::int64_t wide = t.ends ? image::text_width(scale, t.words) : 0;
        image::draw_text(image, t.x * scale - wide, t.y * scale, scale, t.words, ink);
    }
    return image;
}

}  // namespace tessera::bench
