// How far apart two schemes put a surface.
#pragma once

#include "views/colour_map.hpp"
#include "views/view.hpp"

#include <vector>

namespace tessera::views {

/// The diagonal of the box around the corners of all patches, in kernel space; 1 where that has no size.
double patch_diagonal(const patches::PatchSet& patches);

/// Distances of the vertices of two tessellations of one model at equal domain points, in their order, in kernel space.
/// They differ in scheme and normals alone, so that their domain points are the same. Runs both; holds 16 bytes on the
/// host for each vertex meanwhile, and four afterwards.
std::vector<float> scheme_distances(SceneTessellator& a, SceneTessellator& b, const Run& run);

/// Draws the distance of each cell's surface to that of another scheme, in per cent of patch_diagonal(). The scale
/// begins at 0 and ends with the greatest distance in any cell, unless `fixed` says otherwise; where that is 0, it ends
/// with 1. Hair has no scheme and is the same in all: 0. `name` is that of the other scheme, for the legend.
std::unique_ptr<View> make_difference_view(const Subject& subject, Scheme against, const std::string& name,
                                           const std::optional<Scale>& fixed);

}  // namespace tessera::views
