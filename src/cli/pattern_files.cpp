#include "cli/pattern_files.hpp"

#include <fmt/format.h>
#include <cmath>
#include <iterator>

namespace tessera::cli {
namespace {

struct Place {
    double x, y;
};

// In the unit square; triangles are equilateral, of side 1.
Place place(const DomainPoint& point, Domain domain) {
    const double u = point.u / 65536.0;
    const double v = point.v / 65536.0;
    return domain == Domain::triangle ? Place{u + 0.5 * v, std::sqrt(0.75) * v} : Place{u, v};
}

std::size_t corners_of(Domain domain) {
    return domain == Domain::isoline ? 2 : 3;
}

}  // namespace

std::string pattern_svg(const Pattern& pattern, Domain domain) {
    constexpr double side = 600.0;
    constexpr double margin = 20.0;
    const double height = domain == Domain::triangle ? std::sqrt(0.75) : 1.0;
    const double canvas = 2.0 * margin + side * height;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 {0:.0f}\" width=\"640\" height=\"{0:.0f}\">\n"
        "<rect width=\"640\" height=\"{0:.0f}\" fill=\"#fff\"/>\n"
        "<path fill=\"#eaf1f8\" stroke=\"#1f4e79\" stroke-width=\"0.8\" stroke-linejoin=\"round\" d=\"",
        canvas);
    const std::size_t corners = corners_of(domain);
    for (std::size_t first = 0; first + corners <= pattern.indices.size(); first += corners) {
        for (std::size_t k = 0; k < corners; ++k) {
            const Place p = place(pattern.points[pattern.indices[first + k]], domain);
            fmt::format_to(std::back_inserter(svg), "{}{:.3f} {:.3f}", k == 0 ? 'M' : 'L', margin + side * p.x,
                           margin + side * (height - p.y));
        }
        svg += corners == 3 ? "Z\n" : "\n";
    }
    return svg + "\"/>\n</svg>\n";
}

std::string pattern_csv(const Pattern& pattern, Domain domain) {
    std::string csv = "element,index,a,b,c\n";
    for (std::size_t i = 0; i < pattern.points.size(); ++i) {
        fmt::format_to(std::back_inserter(csv), "point,{},{},{},\n", i, pattern.points[i].u, pattern.points[i].v);
    }
    const std::size_t corners = corners_of(domain);
    for (std::size_t first = 0; first + corners <= pattern.indices.size(); first += corners) {
        const std::uint32_t* at = pattern.indices.data() + first;
        if (corners == 3) {
            fmt::format_to(std::back_inserter(csv), "triangle,{},{},{},{}\n", first / 3, at[0], at[1], at[2]);
        } else {
            fmt::format_to(std::back_inserter(csv), "line,{},{},{},\n", first / 2, at[0], at[1]);
        }
    }
    return csv;
}

std::vector<Vertex> pattern_vertices(const Pattern& pattern, Domain domain) {
    std::vector<Vertex> vertices;
    for (const DomainPoint& point : pattern.points) {
        const Place p = place(point, domain);
        vertices.push_back({{static_cast<float>(p.x), static_cast<float>(p.y), 0.0f},
                            {0.0f, 0.0f, 1.0f},
                            {static_cast<float>(point.u) / 65536.0f, static_cast<float>(point.v) / 65536.0f}});
    }
    return vertices;
}

}  // namespace tessera::cli
