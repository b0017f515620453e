// A workload that takes milliseconds.
#pragma once

#include "bench/workload.hpp"

namespace tessera::test {

/// PN triangles of a built-in shape at one factor, integer.
bench::Workload small_workload(const std::string& shape = "shape:icosahedron", float factor = 5.0f);

/// Same with random factors from 1 to 40 per edge, fractional_odd.
bench::Workload uneven_workload();

}  // namespace tessera::test
