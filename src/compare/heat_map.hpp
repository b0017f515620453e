// Errors as colours.
#pragma once

#include "image/image.hpp"

#include <array>
#include <span>

namespace tessera::compare {

/// The colour of an error: black for 0 through violet and red to light yellow for 1, evenly brighter, after
/// matplotlib's magma (by van der Walt and Smith, CC0). Values outside [0, 1] are clamped, and what is no number is
/// white.
std::array<std::uint8_t, 3> heat_colour(float error);

/// An opaque picture of errors, row by row. `errors` holds width * height values.
image::Image heat_map(std::span<const float> errors, std::uint32_t width, std::uint32_t height);

}  // namespace tessera::compare
