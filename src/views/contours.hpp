// Outlines in a picture of depths, and lines along them.
#pragma once

#include "image/text.hpp"
#include "views/depth_picture.hpp"

namespace tessera::views {

/// The middle of a border between two pixels, in half pixels from the upper left of the picture.
struct BorderPoint {
    std::int32_t x2 = 0, y2 = 0;
    bool clear = true;  ///< false for one that is an outline only where it goes on from clear ones
};

/// The borders between neighbouring pixels where one surface ends before another or before nothing: one of both is
/// empty, or their depths are further apart by `jump` than those of the next pixels on either side; unclear ones, by a
/// third of it. The picture's own edges are none.
std::vector<BorderPoint> find_contours(const DepthPicture& picture, float jump);

/// Of borders that touch or nearly do, leaves out those that have fewer than `least` clear ones among them: cracks and
/// steps that come and go with the sampling.
std::vector<BorderPoint> long_contours(const std::vector<BorderPoint>& points, std::size_t least);

/// Draws lines `width` pixels wide, with smooth edges, into a picture that is 1 / `oversampling` times as large as that
/// in which the contours were found.
void draw_contours(image::Image& picture, const std::vector<BorderPoint>& contours, std::uint32_t oversampling,
                   float width, const image::Rgba& colour);

}  // namespace tessera::views
