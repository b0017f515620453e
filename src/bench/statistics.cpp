#include "bench/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace tessera::bench {
namespace {

double quantile(const std::vector<double>& sorted, double part) {
    const double at = part * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

}  // namespace

Summary summarise(std::span<const double> samples) {
    if (samples.empty()) {
        return {};
    }
    std::vector<double> sorted(samples.begin(), samples.end());
    std::ranges::sort(sorted);
    return {quantile(sorted, 0.5), quantile(sorted, 0.25), quantile(sorted, 0.75),
            sorted.front(),        sorted.back(),          sorted.size()};
}

Line fit_line(std::span<const double> x, std::span<const double> y, std::span<const double> weights) {
    assert(x.size() == y.size() && (weights.empty() || weights.size() == x.size()));
    const auto weight = [&](std::size_t i) { return weights.empty() ? 1.0 : weights[i]; };
    double sum = 0.0;
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sum += weight(i);
        mean_x += weight(i) * x[i];
        mean_y += weight(i) * y[i];
    }
    if (sum <= 0.0) {
        return {};
    }
    mean_x /= sum;
    mean_y /= sum;
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += weight(i) * (x[i] - mean_x) * (x[i] - mean_x);
        xy += weight(i) * (x[i] - mean_x) * (y[i] - mean_y);
        yy += weight(i) * (y[i] - mean_y) * (y[i] - mean_y);
    }
    const double slope = xx > 0.0 ? xy / xx : 0.0;
    const double explained = xx > 0.0 && yy > 0.0 ? xy * xy / (xx * yy) : (yy > 0.0 ? 0.0 : 1.0);
    return {mean_y - slope * mean_x, slope, explained};
}

}  // namespace tessera::bench
