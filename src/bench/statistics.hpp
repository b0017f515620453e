// Medians with spread: what a figure is, out of samples on a machine that does other things too.
#pragma once

#include <cstddef>
#include <span>

namespace tessera::bench {

/// Quartiles of samples; all zero where there are none.
struct Summary {
    double median = 0.0;
    double lower = 0.0;  ///< first quartile
    double upper = 0.0;  ///< third quartile
    double least = 0.0;
    double greatest = 0.0;
    std::size_t samples = 0;
};

/// Quantiles are interpolated between neighbouring samples. No sample may be NaN.
Summary summarise(std::span<const double> samples);

/// A straight line through points by least squares: y = constant + slope x.
struct Line {
    double constant = 0.0;
    double slope = 0.0;
    double r_squared = 0.0;  ///< share of the variance that the line explains; 1 for a perfect fit
};

/// `weights` may be empty (all one). At least two different x are needed, else the slope is 0.
Line fit_line(std::span<const double> x, std::span<const double> y, std::span<const double> weights = {});

}  // namespace tessera::bench
