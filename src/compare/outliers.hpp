// Differences pixel by pixel, as they are stored.
#pragma once

#include "image/image.hpp"

#include <array>
#include <vector>

namespace tessera::compare {

/// Counts over two pictures of one size. Symmetric in them.
struct PixelCounts {
    bool equal = true;                    ///< in every bit
    std::uint64_t differing = 0;          ///< pixels that differ in any bit
    std::uint64_t over_tolerance = 0;     ///< pixels of which a channel differs by more than the tolerance
    std::uint64_t outliers = 0;           ///< the same, and no neighbour within a pixel explains it
    std::array<int, 4> max_difference{};  ///< of R, G, B and A, in 8-bit steps
};

/// Channels are compared as they are stored, alpha among them, in 8-bit steps; `tolerance` in [0, 255]. Colours that
/// both pictures hide (alpha 0) count for `equal` and `differing` only. A pixel is an outlier if a channel of one
/// picture lies farther than the tolerance outside the range that the same channel of the other has in the 3 x 3 pixels
/// around: an edge that moves by up to a pixel, or is smoothed in another way, makes none.
PixelCounts count_pixels(const image::Image& a, const image::Image& b, int tolerance);

/// Marks the outliers, row by row.
std::vector<bool> mark_outliers(const image::Image& a, const image::Image& b, int tolerance);

}  // namespace tessera::compare
