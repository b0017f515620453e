// LDR-FLIP: what eyes see of a difference when flipping between two pictures.
#pragma once

#include "compare/backdrop.hpp"

#include <vector>

namespace tessera::compare {

/// A screen of 3840 pixels on 0.7 m, seen from 0.7 m: the viewing distance of the paper.
inline constexpr double default_pixels_per_degree = 0.7 * 3840.0 / 0.7 * 3.14159265358979323846 / 180.0;

/// The FLIP error of every pixel, in [0, 1], row by row: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom,
/// Fairchild, "FLIP: A Difference Evaluator for Alternating Images", 2020. Beyond the borders the pictures go on with
/// their outermost pixels. Both must have the same size; symmetric in them. `pixels_per_degree` in [1, 1000].
std::vector<float> flip_map(const image::Image& a, const image::Image& b, Backdrop backdrop,
                            double pixels_per_degree = default_pixels_per_degree);

}  // namespace tessera::compare
