// A check that stb_image 2.27 lacks.
#pragma once

#include <cstddef>
#include <span>

namespace tessera::image {

/// False for a JPEG with a Huffman table of more than 256 codes, which stb_image before 2.28 writes past the end of
/// its own table for. True for anything else, whether it is a JPEG or not.
bool jpeg_tables_fit(std::span<const std::byte> bytes);

}  // namespace tessera::image
