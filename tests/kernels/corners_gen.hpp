// Random corners of patches for property tests.
#pragma once

#include "schemes/corners.h"

#include <cstdint>
#include <random>

namespace tessera::test {

/// Corners with positions in [-2, 2] and unit normals within reach of the face's own; the same for the same seed.
kernels::Corners random_corners(std::uint32_t seed);

/// A unit vector of any direction.
kernels::Vector random_unit(std::mt19937& random);

}  // namespace tessera::test
