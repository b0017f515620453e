#include "cli/pattern_files.hpp"

#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace tessera::cli {
namespace {

struct Place {
    double x, y;
};

// Barycentric corners of an equilateral triangle of side 1, lower left at the origin.
Place place(const DomainPoint& point) {
    const double u = point.u / 65536.0;
    const double v = point.v / 65536.0;
    return {u + 0.5 * v, std::sqrt(0.75) * v};
}

}  // namespace

std::string pattern_svg(const Pattern& pattern) {
    constexpr double side = 600.0;
    constexpr double margin = 20.0;
    const auto corner = [&](std::uint32_t index) {
        const Place p = place(pattern.points[index]);
        return fmt::format("{:.3f} {:.3f}", margin + side * p.x, margin + side * (std::sqrt(0.75) - p.y));
    };
    std::string svg =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 560\" width=\"640\" height=\"560\">\n"
        "<rect width=\"640\" height=\"560\" fill=\"#fff\"/>\n"
        "<path fill=\"#eaf1f8\" stroke=\"#1f4e79\" stroke-width=\"0.8\" stroke-linejoin=\"round\" d=\"";
    for (std::size_t t = 0; t + 2 < pattern.indices.size(); t += 3) {
        fmt::format_to(std::back_inserter(svg), "M{}L{}L{}Z\n", corner(pattern.indices[t]), corner(pattern.indices[t + 1]),
                       corner(pattern.indices[t + 2]));
    }
    return svg + "\"/>\n</svg>\n";
}

std::string pattern_csv(const Pattern& pattern) {
    std::string csv = "element,index,a,b,c\n";
    for (std::size_t i = 0; i < pattern.points.size(); ++i) {
        fmt::format_to(std::back_inserter(csv), "point,{},{},{},\n", i, pattern.points[i].u, pattern.points[i].v);
    }
    for (std::size_t t = 0; t + 2 < pattern.indices.size(); t += 3) {
        fmt::format_to(std::back_inserter(csv), "triangle,{},{},{},{}\n", t / 3, pattern.indices[t], pattern.indices[t + 1],
                       pattern.indices[t + 2]);
    }
    return csv;
}

std::vector<Vertex> pattern_vertices(const Pattern& pattern) {
    std::vector<Vertex> vertices;
    for (const DomainPoint& point : pattern.points) {
        const Place p = place(point);
        vertices.push_back({{static_cast<float>(p.x), static_cast<float>(p.y), 0.0f}, {0.0f, 0.0f, 1.0f},
                            {static_cast<float>(point.u) / 65536.0f, static_cast<float>(point.v) / 65536.0f}});
    }
    return vertices;
}

}  // namespace tessera::cli
