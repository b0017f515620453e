// What a smooth surface does to a model's outlines.
#pragma once

#include "views/view.hpp"

namespace tessera::views {

/// Colours of the lines.
inline constexpr image::Rgba refined_ink{16, 42, 92, 255}, coarse_ink{226, 88, 34, 255};

/// Draws the outlines of the refined surface and, under them, of the coarse mesh (scheme linear, factor 1) from the
/// same place, over a light shading of the refined one: borders in the picture where the surface ends before the
/// background or before another part of the model that is further away by more than about a 200th of the depth that the
/// model takes (contours.hpp). Each surface hides its own outlines, not those of the other. Found in a picture up to
/// three times as large, so that lines are smooth; borders shorter than a 50th of the picture are left out.
///
/// The subject has no hair. `contours` draws the depths; it may not be the rasteriser of draw().
std::unique_ptr<View> make_silhouette_view(const Subject& subject, std::unique_ptr<render::Rasteriser> contours);

}  // namespace tessera::views
