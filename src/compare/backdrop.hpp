// Pictures with transparency are compared as they look over something.
#pragma once

#include "image/image.hpp"

#include <array>

namespace tessera::compare {

/// What lies behind an image. Whatever a transparent pixel shows, its difference shows over one of the two.
enum class Backdrop { black, white };

/// Red, green and blue; in [0, 1].
using Rgb = std::array<float, 3>;

/// True where the backdrop shows through some pixel.
bool is_transparent(const image::Image& image);

/// The pixel at `rgba` over the backdrop, mixed in linear light; linear. Opaque pixels are decoded exactly (IEC
/// 61966-2-1).
Rgb linear_over(const std::uint8_t* rgba, Backdrop backdrop);

/// The same encoded as sRGB again; opaque pixels keep their value, divided by 255.
Rgb encoded_over(const std::uint8_t* rgba, Backdrop backdrop);

}  // namespace tessera::compare
