#include "compare/comparison.hpp"

#include "base/error.hpp"
#include "compare/psnr.hpp"
#include "compare/ssim.hpp"

#include <fmt/format.h>
#include <algorithm>

namespace tessera::compare {
namespace {

void check(const image::Image& a, const image::Image& b, const CompareOptions& options) {
    if (a.width != b.width || a.height != b.height) {
        throw Error(ErrorKind::usage,
                    fmt::format("Only pictures of the same size can be compared, but the first has {} x {} pixels and "
                                "the second {} x {}.",
                                a.width, a.height, b.width, b.height));
    }
    const std::size_t bytes = std::size_t{a.width} * a.height * 4;
    if (bytes == 0 || a.rgba.size() != bytes || b.rgba.size() != bytes) {
        throw Error(ErrorKind::usage,
                    fmt::format("Pictures of {} x {} pixels must hold {} bytes, and at least a pixel, "
                                "to be compared; these hold {} and {}.",
                                a.width, a.height, bytes, a.rgba.size(), b.rgba.size()));
    }
    if (options.tolerance < 0 || options.tolerance > 255) {
        throw Error(ErrorKind::usage,
                    fmt::format("The tolerance {} is not in [0, 255]; it counts 8-bit steps.", options.tolerance));
    }
    if (!(options.pixels_per_degree >= 1.0 && options.pixels_per_degree <= 1000.0)) {
        throw Error(ErrorKind::usage, fmt::format("{} pixels per degree are not in [1, 1000]; a screen at arm's length "
                                                  "has about 67.",
                                                  options.pixels_per_degree));
    }
}

/// The smallest value that at least 99 of 100 values do not exceed.
float percentile_99(std::vector<float> values) {
    const std::size_t rank = values.size() - values.size() / 100 - 1;
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

void pool_flip(Comparison& result) {
    double sum = 0.0;
    float largest = 0.0f;
    for (const float error : result.flip) {
        sum += double{error};
        largest = std::max(largest, error);
    }
    result.flip_mean = sum / static_cast<double>(result.flip.size());
    result.flip_max = double{largest};
    result.flip_99 = double{percentile_99(result.flip)};
}

}  // namespace

Comparison compare(const image::Image& a, const image::Image& b, const CompareOptions& options) {
    check(a, b, options);
    Comparison result;
    result.width = a.width;
    result.height = a.height;
    result.transparent = is_transparent(a) || is_transparent(b);
    result.pixels = count_pixels(a, b, options.tolerance);
    result.psnr = psnr(a, b, Backdrop::black);
    result.ssim = mean_ssim(a, b, Backdrop::black);
    result.flip = flip_map(a, b, Backdrop::black, options.pixels_per_degree);
    if (result.transparent) {
        result.psnr = std::min(result.psnr, psnr(a, b, Backdrop::white));
        result.ssim = std::min(result.ssim, mean_ssim(a, b, Backdrop::white));
        const std::vector<float> over_white = flip_map(a, b, Backdrop::white, options.pixels_per_degree);
        std::transform(over_white.begin(), over_white.end(), result.flip.begin(), result.flip.begin(),
                       [](float x, float y) { return std::max(x, y); });
    }
    pool_flip(result);
    return result;
}

}  // namespace tessera::compare
