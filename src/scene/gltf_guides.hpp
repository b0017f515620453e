// Lines as guide curves of hair.
#pragma once

#include "scene/gltf_bake.hpp"

namespace tessera::scene {

/// Takes the vertices of a primitive of mode LINE_STRIP as one curve. In mode LINES a segment that begins where the one
/// before ends continues its curve, any other begins a new one: a whole head of hair in one primitive. A single vertex
/// or index left over is noted. `indices` are all < out.positions.size().
void read_guides(const Document& document, std::span<const std::uint32_t> indices, SourcePrimitive& out);

/// Appends the curves of `source` in world space: skin or node transform applied, morph targets not (a message says
/// so). Widths come from the attribute _WIDTH, times the cube root of the transform's determinant. Curves with a
/// position that is not finite, with more than max_guide_points or with no two different points are dropped, repeated
/// points taken once; messages count them.
void bake_guides(const Document& document, const SourcePrimitive& source, const Pose& pose, Guides& out);

}  // namespace tessera::scene
