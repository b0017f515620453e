// Distances between surfaces that were made from the same patches.
#pragma once

#include "measure/patch_surface.hpp"

#include <cstdint>
#include <glm/glm.hpp>

namespace tessera::measure {

/// The distance from a point to the nearest point of a triangle, which may have no area.
double distance_to_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// In the units of the surfaces: kernel space.
struct DistanceStatistics {
    std::uint64_t count = 0;
    double mean = 0.0;
    double max = 0.0;
};

/// From every vertex of `samples` to the nearest point of the same patch of `surface`. Vertices lie on the curved patch
/// itself whatever their pattern, so with a dense pattern this is the distance of a coarse one from the exact surface.
/// Throws Error(usage) where the numbers of patches differ.
DistanceStatistics distance_of_vertices(const PatchSurface& samples, const PatchSurface& surface);

/// From points of the triangles of either surface to the nearest point of the same patch of the other: a grid of
/// (steps + 1) (steps + 2) / 2 points on each triangle, corners included. Throws Error(usage) likewise.
DistanceStatistics distance_between(const PatchSurface& a, const PatchSurface& b, std::uint32_t steps);

/// The diagonal of the box around a surface.
double diagonal(const PatchSurface& surface);

}  // namespace tessera::measure
