#include "views/contours.hpp"

#include <algorithm>
#include <cmath>

namespace tessera::views {
namespace {

/// Whether the surface ends between b and c of four pixels in a row. Where it bends there instead, its step is no
/// larger than on the steeper side; a pixel outside the picture or empty tells of no slope.
bool ends_between(float a, float b, float c, float d, float jump) {
    if ((b < 0.0f) != (c < 0.0f)) return true;
    if (b < 0.0f) return false;
    const float left = a < 0.0f ? 0.0f : std::abs(b - a);
    const float right = d < 0.0f ? 0.0f : std::abs(c - d);
    return std::abs(b - c) > jump + std::max(left, right);
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
    for (std::int32_t y = 0; y < height; ++y) {
        for (std::int32_t x = 0; x < width; ++x) {
            const float here = at(x, y);
            if (x + 1 < width && ends_between(at(x - 1, y), here, at(x + 1, y), at(x + 2, y), jump))
                found.push_back({2 * x + 2, 2 * y + 1});
            if (y + 1 < height && ends_between(at(x, y - 1), here, at(x, y + 1), at(x, y + 2), jump))
                found.push_back({2 * x + 1, 2 * y + 2});
        }
    }
    return found;
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
