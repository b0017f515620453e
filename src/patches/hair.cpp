#include "patches/hair.hpp"

#include "base/error.hpp"
#include "layout.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace tessera::patches {
namespace {

float without_tiny(float x) {
    return std::fabs(x) < 0x1p-30f ? 0.0f : x;
}

float kernel_width(double width, int exponent) {
    return without_tiny(static_cast<float>(std::min(std::scalbn(width, -exponent), double{largest_hair_width})));
}

double mean_length(const scene::Guides& guides) {
    double sum = 0.0;
    std::size_t begin = 0;
    for (const std::uint32_t end : guides.ends) {
        for (std::size_t i = begin + 1; i < end; ++i)
            sum += glm::length(glm::dvec3(guides.points[i]) - glm::dvec3(guides.points[i - 1]));
        begin = end;
    }
    return sum / static_cast<double>(guides.ends.size());
}

void add_points(const scene::Guides& guides, std::optional<float> width, HairSet& set) {
    const double fallback = default_hair_width * mean_length(guides);
    for (std::size_t i = 0; i < guides.points.size(); ++i) {
        const glm::vec3& p = guides.points[i];
        const glm::vec3& n = guides.normals[i];
        const double given = guides.widths[i] == scene::no_width ? fallback : double{guides.widths[i]};
        const auto scaled = [&](float x) { return without_tiny(std::scalbn(x, -set.exponent)); };
        set.points.push_back({{scaled(p.x), scaled(p.y), scaled(p.z)},
                              kernel_width(width ? double{*width} : given, set.exponent),
                              {without_tiny(n.x), without_tiny(n.y), without_tiny(n.z)},
                              0.0f});
    }
}

void add_guides(const scene::Guides& guides, std::uint32_t first_point, HairSet& set) {
    std::uint32_t begin = 0;
    for (const std::uint32_t end : guides.ends) {
        set.guides.push_back({static_cast<std::uint32_t>(set.segments.size()), end - begin - 1});
        for (std::uint32_t i = begin; i + 1 < end; ++i) {
            set.segments.push_back((first_point + i) | (i == begin ? SEGMENT_IS_FIRST : 0u) |
                                   (i + 2 == end ? SEGMENT_IS_LAST : 0u));
        }
        begin = end;
    }
}

void add_patches(const scene::Guides& guides, std::uint32_t first_guide, HairSet& set) {
    std::vector<glm::vec3> roots;
    std::vector<glm::vec3> normals;
    std::uint32_t begin = 0;
    for (const std::uint32_t end : guides.ends) {
        roots.push_back(guides.points[begin]);
        normals.push_back(guides.normals[begin]);
        begin = end;
    }
    for (HairPatch patch : neighbouring_guides(roots, normals)) {
        for (std::uint32_t& guide : patch)
            guide = guide == no_guide ? no_guide : first_guide + guide;
        set.patches.push_back(patch);
    }
}

}  // namespace

HairSet make_hair(const scene::Scene& scene, std::optional<float> width) {
    if (width && !(*width >= 0.0f && std::isfinite(*width))) {
        throw Error(ErrorKind::usage,
                    fmt::format("The hair width is {}; it must be a finite number, not negative.", *width));
    }
    std::uint64_t points = 0;
    for (const scene::Guides& guides : scene.guides)
        points += guides.points.size();
    if (points > SEGMENT_POINT_MASK) {
        throw Error(ErrorKind::usage, fmt::format("{} holds {} points of guide curves, more than the {} supported; "
                                                  "split the model.",
                                                  scene.source, points, SEGMENT_POINT_MASK));
    }
    HairSet set;
    set.exponent = scene_exponent(scene);
    set.points.reserve(points);
    for (const scene::Guides& guides : scene.guides) {
        const auto first_point = static_cast<std::uint32_t>(set.points.size());
        const auto first_guide = static_cast<std::uint32_t>(set.guides.size());
        const std::uint64_t first_patch = set.patches.size();
        add_points(guides, width, set);
        add_guides(guides, first_point, set);
        add_patches(guides, first_guide, set);
        set.ranges.push_back({guides.name, guides.material, first_patch, set.patches.size() - first_patch});
    }
    return set;
}

}  // namespace tessera::patches
