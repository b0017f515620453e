// Domain patterns by themselves: the points and triangles that a set of factors makes, without a surface.
#pragma once

#include "gpu/device.hpp"
#include "tessellate/options.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera {

/// A point of the domain in 16.16 fixed point, 0..65536; for triangles w = 65536 - u - v.
struct DomainPoint {
    std::uint32_t u = 0;
    std::uint32_t v = 0;
};

/// What one patch becomes. Indices are patch-local, three per triangle, two per line segment of isolines; both lists
/// are empty for a culled patch.
struct Pattern {
    std::vector<DomainPoint> points;
    std::vector<std::uint32_t> indices;
};

/// Makes the pattern of every set of factors on the device. `clockwise` is the D3D word: triangles have positive area
/// where u points right and v up; otherwise they are reversed. Lines have no winding.
std::vector<Pattern> make_patterns(gpu::Device device, Domain domain, Partitioning partitioning, bool clockwise,
                                   std::span<const PatchFactors> factors);

}  // namespace tessera
