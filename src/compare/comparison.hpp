// Two pictures in, numbers out.
#pragma once

#include "compare/flip.hpp"
#include "compare/outliers.hpp"

#include <vector>

namespace tessera::compare {

struct CompareOptions {
    int tolerance = 0;  ///< of a channel, in 8-bit steps, [0, 255]
    double pixels_per_degree = default_pixels_per_degree;
};

/// All measures are symmetric in the two pictures. PSNR, SSIM and FLIP are about what is seen. Where either picture is
/// transparent, both are laid over black and over white, and the worse result counts, in FLIP pixel by pixel.
struct Comparison {
    std::uint32_t width = 0, height = 0;
    bool transparent = false;  ///< either picture has a pixel that is not opaque
    PixelCounts pixels;
    double psnr = 0.0;       ///< decibels; infinite where both look the same
    double ssim = 0.0;       ///< [-1, 1]
    double flip_mean = 0.0;  ///< [0, 1]
    double flip_99 = 0.0;    ///< 99th percentile: the least value that 99 of 100 pixels do not exceed
    double flip_max = 0.0;
    std::vector<float> flip;  ///< the error of each pixel, row by row
};

/// Compares two pictures. Besides them it takes 8 bytes a pixel and what tiles take. The result does not depend on the
/// number of threads. Throws Error(usage) for pictures of different sizes or without pixels and for options out of
/// range.
Comparison compare(const image::Image& a, const image::Image& b, const CompareOptions& options = {});

}  // namespace tessera::compare
