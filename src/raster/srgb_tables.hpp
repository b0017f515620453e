// sRGB as the kernels read it: tables of linear floats, made on the host so that every device has the same bits.
#pragma once

#include <cstdint>
#include <vector>

namespace tessera::raster {

/// What every texture buffer begins with (SRGB_DECODE_AT and SRGB_ENCODE_AT of kernels/raster/raster_layout.h), as the
/// bits of floats; LOOK_AT words, those of the mip levels zero.
std::vector<std::uint32_t> make_srgb_tables();

/// The 8-bit sRGB code nearest to linear light in [0, 1].
std::uint32_t encode_srgb(double linear);

}  // namespace tessera::raster
