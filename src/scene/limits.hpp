// How much a file may ask for. Every limit is checked before the memory it guards is allocated.
#pragma once

#include <cstdint>

namespace tessera::scene {

inline constexpr std::uint64_t max_file_bytes = 0x7fffffff;    ///< one file; so offsets fit an int
inline constexpr std::uint64_t max_buffer_bytes = 0x80000000;  ///< all buffers of a document together
inline constexpr std::uint64_t max_json_bytes = 512u << 20;    ///< JSON text, embedded data included
inline constexpr std::uint64_t max_json_values = 1u << 24;     ///< values and names in the JSON text
inline constexpr int max_json_depth = 64;                      ///< nesting of the JSON text
inline constexpr std::uint64_t max_elements = 1u << 20;        ///< entries of one glTF array
inline constexpr std::uint64_t max_vertices = 1u << 26;        ///< of a scene, instances counted
inline constexpr std::uint64_t max_triangles = 1u << 26;       ///< of a scene, instances counted
inline constexpr std::uint64_t max_obj_bytes = 1u << 30;       ///< OBJ text
inline constexpr std::uint64_t max_mtl_bytes = 16u << 20;      ///< text of one material library
inline constexpr std::uint64_t max_corners = 1u << 26;         ///< of all OBJ faces together
inline constexpr std::uint64_t max_face_corners = 4096;        ///< of one OBJ face; ear clipping is quadratic in it
inline constexpr std::uint64_t max_zero_elements = 1u << 24;   ///< of an accessor that has no data of its own
inline constexpr std::uint64_t max_guide_points = 4096;        ///< of one guide curve of hair
inline constexpr std::uint64_t max_image_bytes = 0x80000000;   ///< decoded pixels of a scene

}  // namespace tessera::scene
