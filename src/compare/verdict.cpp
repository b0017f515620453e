#include "compare/verdict.hpp"

#include <fmt/format.h>

namespace tessera::compare {

Verdict judge(const Comparison& comparison, const Gates& gates) {
    Verdict verdict;
    const PixelCounts& pixels = comparison.pixels;
    if (!gates.max_flip && !gates.max_outliers && !pixels.equal) {
        verdict.failures.push_back(fmt::format("{} pixels differ, and no difference was allowed.", pixels.differing));
    }
    // Written so that a number that is none fails.
    if (gates.max_flip && !(comparison.flip_mean <= *gates.max_flip)) {
        verdict.failures.push_back(
            fmt::format("The mean of FLIP is {:.6f}, more than {}.", comparison.flip_mean, *gates.max_flip));
    }
    if (gates.max_outliers && pixels.outliers > *gates.max_outliers) {
        verdict.failures.push_back(
            fmt::format("{} pixels are outliers, more than {}.", pixels.outliers, *gates.max_outliers));
    }
    verdict.pass = verdict.failures.empty();
    return verdict;
}

}  // namespace tessera::compare
