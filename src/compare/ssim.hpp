// Structural similarity.
#pragma once

#include "compare/backdrop.hpp"

namespace tessera::compare {

/// The mean SSIM index of two pictures of one size: Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment: from
/// error visibility to structural similarity", 2004. Luma of ITU-R BT.601 in [0, 255]; windows of 11 x 11 pixels with a
/// Gaussian of standard deviation 1.5, all that lie inside the picture; K1 = 0.01, K2 = 0.03. In [-1, 1], 1 where the
/// lumas are equal. Along a side shorter than 11 pixels windows are cut off at the borders and weighted anew.
/// Symmetric.
double mean_ssim(const image::Image& a, const image::Image& b, Backdrop backdrop);

}  // namespace tessera::compare
