#include "compare/flip.hpp"

#include "compare/flip_filters.hpp"
#include "compare/opponent_colour.hpp"
#include "compare/tiles.hpp"

#include <cmath>

namespace tessera::compare {
namespace {

/// Values of a rectangle, row by row.
struct Plane {
    std::int64_t width = 0, height = 0;
    std::vector<float> values;

    Plane(std::int64_t w, std::int64_t h) : width(w), height(h), values(static_cast<std::size_t>(w * h)) {}
    float* row(std::int64_t y) { return values.data() + y * width; }
    const float* row(std::int64_t y) const { return values.data() + y * width; }
};

/// sum[x] += taps[k] * row[x + k]: inner loops run along x, where the compiler vectorises them.
void add_filtered(float* sum, std::int64_t width, const float* row, const Taps& taps) {
    for (std::size_t k = 0; k < taps.size(); ++k) {
        const float tap = taps[k];
        const float* from = row + k;
        for (std::int64_t x = 0; x < width; ++x)
            sum[x] += tap * from[x];
    }
}

/// Filters rows. `margin` is that of `in` around the result, at least the radius; rows of the margin are filtered too,
/// for the columns to come.
Plane filter_rows(const Plane& in, const Taps& taps, std::int64_t margin) {
    const auto radius = static_cast<std::int64_t>(taps.size() / 2);
    Plane out(in.width - 2 * margin, in.height);
    for (std::int64_t y = 0; y < in.height; ++y)
        add_filtered(out.row(y), out.width, in.row(y) + (margin - radius), taps);
    return out;
}

Plane filter_columns(const Plane& in, const Taps& taps, std::int64_t margin) {
    const auto radius = static_cast<std::int64_t>(taps.size() / 2);
    Plane out(in.width, in.height - 2 * margin);
    for (std::int64_t y = 0; y < out.height; ++y) {
        float* sum = out.row(y);
        for (std::size_t k = 0; k < taps.size(); ++k) {
            const float tap = taps[k];
            const float* from = in.row(y + margin - radius + static_cast<std::int64_t>(k));
            for (std::int64_t x = 0; x < in.width; ++x)
                sum[x] += tap * from[x];
        }
    }
    return out;
}

struct Filters {
    ContrastSensitivity contrast;
    FeatureDetectors feature;
    std::int64_t margin;

    explicit Filters(double pixels_per_degree)
        : contrast(make_contrast_sensitivity(pixels_per_degree)),
          feature(make_feature_detectors(pixels_per_degree)),
          margin(std::max(contrast.radius, feature.radius)) {}

    Plane both(const Plane& in, const Taps& along_rows, const Taps& along_columns) const {
        return filter_columns(filter_rows(in, along_rows, margin), along_columns, margin);
    }
};

/// What an eye makes of a tile of one picture.
struct Perception {
    std::vector<Opponent> colour;    ///< adjusted L*a*b*
    std::vector<float> edge, point;  ///< strength of features
};

/// A tile and its margin in opponent colours.
std::array<Plane, 3> opponent_planes(const image::Image& image, Backdrop backdrop, const Tile& tile,
                                     std::int64_t margin) {
    const std::int64_t width = tile.width + 2 * margin;
    const std::int64_t height = tile.height + 2 * margin;
    std::array<Plane, 3> planes{Plane(width, height), Plane(width, height), Plane(width, height)};
    for (std::int64_t y = 0; y < height; ++y) {
        const std::int64_t from_y = std::clamp(tile.y + y - margin, std::int64_t{0}, std::int64_t{image.height} - 1);
        for (std::int64_t x = 0; x < width; ++x) {
            const std::int64_t from_x = std::clamp(tile.x + x - margin, std::int64_t{0}, std::int64_t{image.width} - 1);
            const auto pixel = static_cast<std::size_t>(from_y * image.width + from_x);
            const Opponent colour = to_ycxcz(linear_over(&image.rgba[pixel * 4], backdrop));
            planes[0].row(y)[x] = colour.luminance;
            planes[1].row(y)[x] = colour.red_green;
            planes[2].row(y)[x] = colour.blue_yellow;
        }
    }
    return planes;
}

std::vector<float> lengths(const Plane& x, const Plane& y) {
    std::vector<float> result(x.values.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
    return result;
}

Perception perceive(const image::Image& image, Backdrop backdrop, const Tile& tile, const Filters& filters) {
    std::array<Plane, 3> planes = opponent_planes(image, backdrop, tile, filters.margin);
    const auto& contrast = filters.contrast;
    const Plane luminance = filters.both(planes[0], contrast.luminance, contrast.luminance);
    const Plane red_green = filters.both(planes[1], contrast.red_green, contrast.red_green);
    const Plane wide = filters.both(planes[2], contrast.blue_yellow_wide, contrast.blue_yellow_wide);
    const Plane narrow = filters.both(planes[2], contrast.blue_yellow_narrow, contrast.blue_yellow_narrow);

    Perception result;
    result.colour.resize(luminance.values.size());
    for (std::size_t i = 0; i < result.colour.size(); ++i) {
        const float blue_yellow =
            wide.values[i] * (1.0f - contrast.narrow_share) + narrow.values[i] * contrast.narrow_share;
        result.colour[i] = to_adjusted_lab(from_ycxcz({luminance.values[i], red_green.values[i], blue_yellow}));
    }

    // Features are those of the sharp picture, its luminance in [0, 1].
    for (float& value : planes[0].values)
        value = (value + 16.0f) / 116.0f;
    const auto& feature = filters.feature;
    const Plane smooth = filter_rows(planes[0], feature.smooth, filters.margin);
    const auto strength = [&](const Taps& derivative) {
        return lengths(filters.both(planes[0], derivative, feature.smooth),
                       filter_columns(smooth, derivative, filters.margin));
    };
    result.edge = strength(feature.edge);
    result.point = strength(feature.point);
    return result;
}

constexpr float colour_exponent = 0.7f, feature_exponent = 0.5f;
// Differences up to 0.4 of the largest one take the share 0.95 of [0, 1], the rest what is left (section 4.1.3).
constexpr float knee_in = 0.4f, knee_out = 0.95f;

/// The largest difference of colours: between green and blue.
float largest_difference() {
    return std::pow(hyab(to_adjusted_lab({0.0f, 1.0f, 0.0f}), to_adjusted_lab({0.0f, 0.0f, 1.0f})), colour_exponent);
}

float colour_error(const Opponent& a, const Opponent& b, float largest) {
    const float share = std::pow(hyab(a, b), colour_exponent) / largest;
    return share < knee_in ? share * (knee_out / knee_in)
                           : std::min(knee_out + (share - knee_in) / (1.0f - knee_in) * (1.0f - knee_out), 1.0f);
}

float feature_error(const Perception& a, const Perception& b, std::size_t i) {
    const float apart = std::max(std::abs(a.edge[i] - b.edge[i]), std::abs(a.point[i] - b.point[i]));
    return std::min(std::pow(apart * std::sqrt(0.5f), feature_exponent), 1.0f);
}

}  // namespace

std::vector<float> flip_map(const image::Image& a, const image::Image& b, Backdrop backdrop, double pixels_per_degree) {
    const Filters filters(pixels_per_degree);
    const float largest = largest_difference();
    std::vector<float> map(std::size_t{a.width} * a.height);
    for_each_tile(a.width, a.height, [&](std::size_t, const Tile& tile) {
        const Perception seen_a = perceive(a, backdrop, tile, filters);
        const Perception seen_b = perceive(b, backdrop, tile, filters);
        std::size_t i = 0;
        for (std::int64_t y = tile.y; y < tile.y + tile.height; ++y) {
            float* const row = &map[static_cast<std::size_t>(y * a.width)];
            for (std::int64_t x = tile.x; x < tile.x + tile.width; ++x, ++i) {
                // Features raise the colour error (section 4.3).
                row[x] = std::pow(colour_error(seen_a.colour[i], seen_b.colour[i], largest),
                                  1.0f - feature_error(seen_a, seen_b, i));
            }
        }
    });
    return map;
}

}  // namespace tessera::compare
