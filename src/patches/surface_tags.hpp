// Shape factors, scalar tags and creases of a scene, as patches carry them.
#pragma once

#include "patches/patches.hpp"

namespace tessera::patches {

/// Fills `vertex_tags` and `corner_tags` of `set`, which otherwise is complete, where the scene has anything to fill
/// them with: alphas, scalar tags, or subdivision tags (creases and corners). Vertices at bitwise equal positions are
/// one vertex of a crease, in all meshes together.
///
/// A crease of sharpness s by OpenSubdiv's measure (0 smooth, 10 and more infinitely sharp) becomes 1 - 2^-s, taken
/// linearly between whole s, and 1 from 10 on; a corner likewise becomes the sharpness of its vertex. Around a vertex
/// that creases touch, every face's normal is the angle-weighted mean over the faces at its vertex, those beyond a
/// crease counting 1 - sharpness as much: faces that a smooth edge joins share a normal, faces apart from each other
/// by a sharp crease do not. (At a vertex where more than 64 such fans meet, each stands alone.) Where exactly two
/// creases meet and the vertex is no corner, the crease runs through it in the direction from one neighbour to the
/// other.
void add_surface_tags(const scene::Scene& scene, PatchSet& set);

/// OpenSubdiv's sharpness as a share: see add_surface_tags.
float crease_share(float sharpness);

}  // namespace tessera::patches
