#include "compare/ssim.hpp"

#include "compare/tiles.hpp"

#include <cmath>
#include <vector>

namespace tessera::compare {
namespace {

constexpr std::int64_t radius = 5;

double luma(const std::uint8_t* rgba, Backdrop backdrop) {
    const Rgb rgb = encoded_over(rgba, backdrop);
    return 255.0 * (0.299 * double{rgb[0]} + 0.587 * double{rgb[1]} + 0.114 * double{rgb[2]});
}

/// Where the windows of one side are centred, and how they reach: [centre - radius, centre + radius], cut off where
/// the side is too short for any to fit.
struct Side {
    std::int64_t size;
    bool whole() const { return size > 2 * radius; }
    std::int64_t windows() const { return whole() ? size - 2 * radius : size; }
    std::int64_t first_centre() const { return whole() ? radius : 0; }
};

using Weights = std::array<double, 2 * radius + 1>;

/// The weights of the window centred at `centre`, 0 beyond the picture, adding up to 1.
Weights weights_at(const Side& side, std::int64_t centre) {
    Weights weights{};
    double sum = 0.0;
    for (std::int64_t i = -radius; i <= radius; ++i) {
        if (centre + i < 0 || centre + i >= side.size) continue;
        const double x = static_cast<double>(i) / 1.5;
        sum += weights[static_cast<std::size_t>(i + radius)] = std::exp(-0.5 * x * x);
    }
    for (double& weight : weights)
        weight /= sum;
    return weights;
}

/// Weighted means of a, b, aa, bb, ab over a window or a column of it.
using Moments = std::array<double, 5>;

void add(Moments& sum, double weight, const Moments& moments) {
    for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += weight * moments[i];
}

double ssim(const Moments& m) {
    constexpr double c1 = (0.01 * 255.0) * (0.01 * 255.0), c2 = (0.03 * 255.0) * (0.03 * 255.0);
    const double both = m[0] * m[1];
    const double squares = m[0] * m[0] + m[1] * m[1];
    const double variances = m[2] + m[3] - squares;
    return (2.0 * both + c1) * (2.0 * (m[4] - both) + c2) / ((squares + c1) * (variances + c2));
}

double sum_over_tile(const image::Image& a, const image::Image& b, Backdrop backdrop, const Tile& tile,
                     const Side& wide, const Side& high) {
    // The pixels under the tile's windows.
    const std::int64_t left = std::max(tile.x + wide.first_centre() - radius, std::int64_t{0});
    const std::int64_t right = std::min(tile.x + wide.first_centre() + tile.width + radius, wide.size);
    const std::int64_t top = std::max(tile.y + high.first_centre() - radius, std::int64_t{0});
    const std::int64_t bottom = std::min(tile.y + high.first_centre() + tile.height + radius, high.size);

    std::vector<Weights> across;
    for (std::int64_t window = 0; window < tile.width; ++window)
        across.push_back(weights_at(wide, tile.x + window + wide.first_centre()));
    std::vector<Moments> rows(static_cast<std::size_t>((bottom - top) * tile.width));
    std::vector<Moments> pixels(static_cast<std::size_t>(right - left));
    for (std::int64_t y = top; y < bottom; ++y) {
        for (std::int64_t x = left; x < right; ++x) {
            const auto pixel = static_cast<std::size_t>(y * a.width + x) * 4;
            const double p = luma(&a.rgba[pixel], backdrop);
            const double q = luma(&b.rgba[pixel], backdrop);
            pixels[static_cast<std::size_t>(x - left)] = {p, q, p * p, q * q, p * q};
        }
        for (std::int64_t window = 0; window < tile.width; ++window) {
            const std::int64_t centre = tile.x + window + wide.first_centre();
            const Weights& weights = across[static_cast<std::size_t>(window)];
            Moments& sum = rows[static_cast<std::size_t>((y - top) * tile.width + window)];
            for (std::int64_t x = std::max(centre - radius, left); x <= std::min(centre + radius, right - 1); ++x) {
                add(sum, weights[static_cast<std::size_t>(x - centre + radius)],
                    pixels[static_cast<std::size_t>(x - left)]);
            }
        }
    }
    double total = 0.0;
    for (std::int64_t row = 0; row < tile.height; ++row) {
        const std::int64_t centre = tile.y + row + high.first_centre();
        const Weights weights = weights_at(high, centre);
        for (std::int64_t window = 0; window < tile.width; ++window) {
            Moments sum{};
            for (std::int64_t y = std::max(centre - radius, top); y <= std::min(centre + radius, bottom - 1); ++y) {
                add(sum, weights[static_cast<std::size_t>(y - centre + radius)],
                    rows[static_cast<std::size_t>((y - top) * tile.width + window)]);
            }
            total += ssim(sum);
        }
    }
    return total;
}

}  // namespace

double mean_ssim(const image::Image& a, const image::Image& b, Backdrop backdrop) {
    const Side wide{a.width};
    const Side high{a.height};
    const auto columns = static_cast<std::uint32_t>(wide.windows());
    const auto rows = static_cast<std::uint32_t>(high.windows());
    std::vector<double> sums(tile_count(columns, rows));
    for_each_tile(columns, rows, [&](std::size_t number, const Tile& tile) {
        sums[number] = sum_over_tile(a, b, backdrop, tile, wide, high);
    });
    double total = 0.0;
    for (const double sum : sums)
        total += sum;
    return total / (static_cast<double>(columns) * static_cast<double>(rows));
}

}  // namespace tessera::compare
