#include "views/contours.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace tessera::views {
namespace {

/// How far the depth jumps between b and c of four pixels in a row, where the surface ends between them. Where it bends
/// there instead, its step is no larger than on the steeper side; a pixel outside the picture or empty tells of no
/// slope.
float jump_between(float a, float b, float c, float d) {
    if ((b < 0.0f) != (c < 0.0f)) return 1.0f;
    if (b < 0.0f) return 0.0f;
    const float left = a < 0.0f ? 0.0f : std::abs(b - a);
    const float right = d < 0.0f ? 0.0f : std::abs(c - d);
    return std::abs(b - c) - std::max(left, right);
}

std::uint64_t key_of(std::int32_t x2, std::int32_t y2) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(y2)) << 32u | static_cast<std::uint32_t>(x2);
}

/// `under` with `share` of a colour over it.
void blend(std::uint8_t* under, const image::Rgba& colour, double share) {
    const double below = under[3] / 255.0, alpha = share + below * (1.0 - share);
    for (std::size_t c = 0; c < 3; ++c) {
        const double mixed = (colour[c] * share + under[c] * below * (1.0 - share)) / std::max(alpha, 1e-9);
        under[c] = static_cast<std::uint8_t>(std::lround(std::clamp(mixed, 0.0, 255.0)));
    }
    under[3] = static_cast<std::uint8_t>(std::lround(alpha * 255.0));
}

}  // namespace

std::vector<BorderPoint> find_contours(const DepthPicture& picture, float jump) {
    const auto width = static_cast<std::int32_t>(picture.width), height = static_cast<std::int32_t>(picture.height);
    const auto at = [&](std::int32_t x, std::int32_t y) {
        if (x < 0 || y < 0 || x >= width || y >= height) return -1.0f;
        return picture.depths[static_cast<std::size_t>(y) * picture.width + static_cast<std::size_t>(x)];
    };
    std::vector<BorderPoint> found;
    const auto add = [&](std::int32_t x2, std::int32_t y2, float height) {
        if (height > jump / 3.0f) found.push_back({x2, y2, height > jump});
    };
    for (std::int32_t y = 0; y < height; ++y) {
        for (std::int32_t x = 0; x < width; ++x) {
            const float here = at(x, y);
            if (x + 1 < width) add(2 * x + 2, 2 * y + 1, jump_between(at(x - 1, y), here, at(x + 1, y), at(x + 2, y)));
            if (y + 1 < height) add(2 * x + 1, 2 * y + 2, jump_between(at(x, y - 1), here, at(x, y + 1), at(x, y + 2)));
        }
    }
    return found;
}

std::vector<BorderPoint> long_contours(const std::vector<BorderPoint>& points, std::size_t least) {
    constexpr std::int32_t near = 3;  // half pixels
    std::unordered_map<std::uint64_t, std::size_t> waiting;
    for (std::size_t i = 0; i < points.size(); ++i)
        waiting.emplace(key_of(points[i].x2, points[i].y2), i);
    std::vector<BorderPoint> kept;
    std::vector<std::size_t> contour;
    for (std::size_t first = 0; first < points.size(); ++first) {
        if (waiting.erase(key_of(points[first].x2, points[first].y2)) == 0) continue;
        contour.assign(1, first);
        for (std::size_t k = 0; k < contour.size(); ++k) {
            const BorderPoint point = points[contour[k]];
            for (std::int32_t dy = -near; dy <= near; ++dy) {
                for (std::int32_t dx = -near; dx <= near; ++dx) {
                    const auto found = waiting.find(key_of(point.x2 + dx, point.y2 + dy));
                    if (found == waiting.end()) continue;
                    contour.push_back(found->second);
                    waiting.erase(found);
                }
            }
        }
        const auto clear = std::ranges::count_if(contour, [&](std::size_t i) { return points[i].clear; });
        if (static_cast<std::size_t>(clear) < least) continue;
        for (const std::size_t i : contour)
            kept.push_back(points[i]);
    }
    return kept;
}

void draw_contours(image::Image& picture, const std::vector<BorderPoint>& contours, std::uint32_t oversampling,
                   float width, const image::Rgba& colour) {
    const std::size_t wide = std::size_t{picture.width} * oversampling,
                      high = std::size_t{picture.height} * oversampling;
    std::vector<std::uint8_t> mask(wide * high, 0);
    const float radius = 0.5f * width * static_cast<float>(oversampling);
    for (const BorderPoint& point : contours) {
        const float x = 0.5f * static_cast<float>(point.x2), y = 0.5f * static_cast<float>(point.y2);
        const auto first = [&](float centre) {
            return static_cast<std::size_t>(std::max(std::ceil(centre - radius - 0.5f), 0.0f));
        };
        const auto last = [&](float centre, std::size_t count) {
            return std::min(static_cast<std::size_t>(std::max(std::floor(centre + radius + 0.5f), 0.0f)), count);
        };
        for (std::size_t py = first(y); py < last(y, high); ++py) {
            const float dy = static_cast<float>(py) + 0.5f - y;
            for (std::size_t px = first(x); px < last(x, wide); ++px) {
                const float dx = static_cast<float>(px) + 0.5f - x;
                if (dx * dx + dy * dy <= radius * radius) mask[py * wide + px] = 1;
            }
        }
    }
    const double samples = static_cast<double>(oversampling * oversampling);
    for (std::size_t y = 0; y < picture.height; ++y) {
        for (std::size_t x = 0; x < picture.width; ++x) {
            std::uint32_t hit = 0;
            for (std::size_t row = 0; row < oversampling; ++row) {
                for (std::size_t column = 0; column < oversampling; ++column)
                    hit += mask[(y * oversampling + row) * wide + x * oversampling + column];
            }
            if (hit > 0) blend(&picture.rgba[4 * (y * picture.width + x)], colour, hit / samples);
        }
    }
}

}  // namespace tessera::views
