// Sets of tessellation factors that leave no corner of the factor space out.
#pragma once

#include "tessellate/options.hpp"

#include <cstdint>
#include <vector>

namespace tessera::test {

/// Every integer 1..64 on all factors, and each as the only one that differs from 5; fractions around every integer;
/// values that cull, clamp or are no numbers, one place at a time.
std::vector<PatchFactors> systematic_factors(Domain domain);

/// `count` sets, the same for the same seed: independent factors from 0.5 to 66 (small ones more often, so that a run
/// stays short), integers, values close to integers, and now and then something odd in one place.
std::vector<PatchFactors> random_factor_sets(std::size_t count, std::uint64_t seed);

/// How many random sets a test takes: TESSERA_ORACLE_SETS, or 500 per winding. A long run takes 5000.
std::size_t random_set_count();

}  // namespace tessera::test
