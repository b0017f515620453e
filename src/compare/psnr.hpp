// Peak signal-to-noise ratio.
#pragma once

#include "compare/backdrop.hpp"

namespace tessera::compare {

/// 10 log10(255^2 / mean squared error) in decibels, over red, green and blue of all pixels as they are encoded;
/// infinite where the two pictures, of one size, look the same. Symmetric.
double psnr(const image::Image& a, const image::Image& b, Backdrop backdrop);

}  // namespace tessera::compare
