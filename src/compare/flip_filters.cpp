#include "compare/flip_filters.hpp"

#include <cmath>
#include <numbers>

namespace tessera::compare {
namespace {

constexpr double pi = std::numbers::pi;

/// A contrast sensitivity a * exp(-b f^2) of spatial frequency f in cycles per degree (table 1 of the paper).
struct Sensitivity {
    double a, b;
    /// The factor of its transform in two dimensions, a * sqrt(pi / b) * exp(-pi^2 x^2 / b) for x in degrees.
    double weight() const { return a * std::sqrt(pi / b); }
};
constexpr Sensitivity of_luminance{1.0, 0.0047}, of_red_green{1.0, 0.0053}, of_blue_yellow{34.1, 0.04},
    of_blue_yellow_narrow{13.5, 0.025};

std::vector<double> gaussian(const Sensitivity& sensitivity, double pixels_per_degree, int radius) {
    std::vector<double> taps;
    for (int i = -radius; i <= radius; ++i) {
        const double x = i / pixels_per_degree;
        taps.push_back(std::exp(-pi * pi * x * x / sensitivity.b));
    }
    return taps;
}

double sum(const std::vector<double>& taps) {
    double total = 0.0;
    for (const double tap : taps)
        total += tap;
    return total;
}

/// Divides positive taps by their sum and negative ones by the magnitude of theirs.
Taps normalised(const std::vector<double>& taps) {
    double positive = 0.0;
    double negative = 0.0;
    for (const double tap : taps)
        (tap > 0.0 ? positive : negative) += tap;
    Taps result;
    for (const double tap : taps)
        result.push_back(static_cast<float>(tap == 0.0 ? 0.0 : tap / (tap > 0.0 ? positive : -negative)));
    return result;
}

}  // namespace

ContrastSensitivity make_contrast_sensitivity(double pixels_per_degree) {
    ContrastSensitivity filters;
    // Three standard deviations of the widest, for all alike.
    const double widest = std::sqrt(of_blue_yellow.b / (2.0 * pi * pi));
    filters.radius = static_cast<int>(std::ceil(3.0 * widest * pixels_per_degree));
    const auto taps = [&](const Sensitivity& of) { return gaussian(of, pixels_per_degree, filters.radius); };
    filters.luminance = normalised(taps(of_luminance));
    filters.red_green = normalised(taps(of_red_green));
    const auto wide = taps(of_blue_yellow);
    const auto narrow = taps(of_blue_yellow_narrow);
    filters.blue_yellow_wide = normalised(wide);
    filters.blue_yellow_narrow = normalised(narrow);
    const double wide_volume = of_blue_yellow.weight() * sum(wide) * sum(wide);
    const double narrow_volume = of_blue_yellow_narrow.weight() * sum(narrow) * sum(narrow);
    filters.narrow_share = static_cast<float>(narrow_volume / (wide_volume + narrow_volume));
    return filters;
}

FeatureDetectors make_feature_detectors(double pixels_per_degree) {
    constexpr double width = 0.082;  // degrees, of the features that eyes detect best
    const double sigma = 0.5 * width * pixels_per_degree;
    FeatureDetectors filters;
    filters.radius = static_cast<int>(std::ceil(3.0 * sigma));
    std::vector<double> smooth, edge, point;
    for (int i = -filters.radius; i <= filters.radius; ++i) {
        const double x = i / sigma;
        const double weight = std::exp(-0.5 * x * x);
        smooth.push_back(weight);
        edge.push_back(-x * weight);
        point.push_back((x * x - 1.0) * weight);
    }
    filters.smooth = normalised(smooth);
    filters.edge = normalised(edge);
    filters.point = normalised(point);
    return filters;
}

}  // namespace tessera::compare
