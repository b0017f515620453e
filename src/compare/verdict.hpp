// PASS or FAIL.
#pragma once

#include "compare/comparison.hpp"

#include <optional>
#include <string>

namespace tessera::compare {

/// What a comparison is held against. Both kinds matter: means miss small errors, counts of pixels trip on edges.
/// Without any the pictures must be equal in every bit.
struct Gates {
    std::optional<double> max_flip;             ///< the largest mean of FLIP, [0, 1]
    std::optional<std::uint64_t> max_outliers;  ///< the most pixels that may be outliers
};

struct Verdict {
    bool pass = true;
    std::vector<std::string> failures;  ///< a sentence for each gate that failed
};

Verdict judge(const Comparison& comparison, const Gates& gates);

}  // namespace tessera::compare
