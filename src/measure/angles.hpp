// Angles between normals, and their statistics.
#pragma once

#include "measure/patch_surface.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera::measure {

/// The angle between two vectors of any length above 0, in radians, [0, pi]; exact to about 1e-7 for floats of unit
/// length, small angles included.
double angle_between(const float (&a)[3], const float (&b)[3]);

/// Radians; all zero where there is no angle.
struct AngleStatistics {
    std::uint64_t count = 0;
    double mean = 0.0;
    double most_95 = 0.0;  ///< 95 of 100 are at most this
    double max = 0.0;
};

AngleStatistics summarise(std::vector<double> angles);

/// The angles between the normals of two surfaces, vertex by vertex. Throws Error(usage) where they have not the same
/// positions, bit by bit.
AngleStatistics normal_angles(const PatchSurface& a, const PatchSurface& b);

}  // namespace tessera::measure
