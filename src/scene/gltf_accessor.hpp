// Accessors: arrays of numbers somewhere in the buffers. The readers rely on check_accessors.
#pragma once

#include "scene/gltf_document.hpp"

#include <cstdint>
#include <vector>

namespace tessera::scene {

/// Numbers of one element (3 for VEC3, 16 for MAT4).
int components_of(const tinygltf::Accessor& accessor);

/// Checks that every buffer view lies in its buffer, and every accessor with all its parts in its views.
void check_accessors(const Document& document);

/// All numbers of an accessor, element after element, sparse values applied; normalised integers become [0,1] or
/// [-1,1] (glTF 2.0, section 3.11), others keep their value. Matrices only with 4-byte components.
std::vector<float> read_floats(const Document& document, int accessor);

/// The same for unsigned integer accessors.
std::vector<std::uint32_t> read_unsigned(const Document& document, int accessor);

/// The bytes of a buffer view.
std::span<const std::byte> view_bytes(const Document& document, int buffer_view);

}  // namespace tessera::scene
