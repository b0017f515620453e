// Surfaces with known answers.
#pragma once

#include "measure/patch_surface.hpp"

#include <numbers>
#include <string>

namespace tessera::test {

inline constexpr double degree = std::numbers::pi / 180.0;  ///< in radians

/// A loaded model or shape as patches.
patches::PatchSet load_patches(const std::string& name);

/// Two unit squares, each of two triangles, that meet in the y axis at an angle: one in the plane z = 0 with x < 0,
/// the other turned up out of it by `turn` radians, with x > 0. Control vertices are shared in the axis, where normals
/// are (0, 0, 1); with `split`, each square has its own there.
patches::PatchSet folded_sheet(double turn, bool split);

/// Made on the reference device with one factor, whatever `options` says of factors.
measure::PatchSurface make_surface(const patches::PatchSet& patches, TessellationOptions options, float factor);

}  // namespace tessera::test
