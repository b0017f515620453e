// A device's own rasteriser against the portable one: not the same bits, but the same picture.
#pragma once

#include "compare/comparison.hpp"
#include "verify/compare_pictures.hpp"

#include <optional>

namespace tessera::verify {

/// What is expected of two right rasterisers at 4 samples per pixel: no more than this mean of FLIP,
inline constexpr double most_flip = 0.01;
/// and no outliers off edges beyond this tolerance (compare/outliers.hpp), in 8-bit steps: highlights of Shading::phong
/// are steep.
inline constexpr int outlier_steps = 24;

struct RasteriserComparison {
    double flip_mean = 0.0;
    std::uint64_t pixels = 0;
    std::uint64_t over_tolerance = 0;      ///< pixels of which a channel differs by more than outlier_steps
    std::uint64_t outliers = 0;            ///< of these, what no neighbour within a pixel explains
    std::uint64_t off_edges = 0;           ///< outliers that do not lie on an edge (find_edges)
    std::optional<PixelDifference> first;  ///< of those off edges; what is expected is the portable one's

    bool is_close() const { return flip_mean <= most_flip && off_edges == 0; }
};

/// Tessellates on `device`, draws the frame with both rasterisers, and compares. `pictures` (may be null) gets the own
/// and the portable one's.
RasteriserComparison compare_rasterisers(const gpu::Device& device, const PictureSubject& subject,
                                         const render::Frame& frame, render::Rasteriser& own,
                                         render::Rasteriser& portable, std::vector<image::Image>* pictures = nullptr);

}  // namespace tessera::verify
