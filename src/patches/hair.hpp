// A scene's guide curves as the hair kernels want them: scaled points, segments, and patches of neighbouring guides.
#pragma once

#include "patches/guide_neighbours.hpp"
#include "patches/patches.hpp"

#include <optional>

namespace tessera::patches {

/// A point of a guide, as the kernels lay it out.
struct GuidePoint {
    float position[3];
    float width;      ///< full, in kernel space; never negative
    float normal[3];  ///< unit, or zero for none
    float unused;     ///< zero
};
static_assert(sizeof(GuidePoint) == 32);

/// A guide: segments [first_segment, first_segment + segment_count) of the set.
struct GuideRange {
    std::uint32_t first_segment = 0;
    std::uint32_t segment_count = 0;
};

/// All guides of a scene. Numbers of magnitude under 2^-30 are zero in points, normals and widths, so that no product
/// of the kernels is denormal.
struct HairSet {
    std::vector<GuidePoint> points;  ///< positions and widths times 2^-exponent
    std::vector<std::uint32_t>
        segments;  ///< the number of each one's first point and SEGMENT_IS_... (kernels/layout.h)
    std::vector<GuideRange> guides;
    std::vector<HairPatch> patches;  ///< of guides in this set
    std::vector<PatchRange> ranges;  ///< of patches, one for each of the scene's Guides
    int exponent = 0;                ///< as of the scene's PatchSet

    bool empty() const { return patches.empty(); }
};

/// Widths above this, in kernel space, are cut: twice the size of the largest model.
inline constexpr float largest_hair_width = 4.0f;

/// Where the file gives no width, hair is this share of the mean length of the guides it belongs to.
inline constexpr double default_hair_width = 0.01;

/// Makes the set; an empty one of a scene without guides. `width` replaces the widths of the file (the model's units).
/// Throws Error(usage) for a width that is negative or not finite.
HairSet make_hair(const scene::Scene& scene, std::optional<float> width = {});

}  // namespace tessera::patches
