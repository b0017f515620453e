// The text of an OBJ file before tinyobjloader sees it. That reader takes damaged numbers for zeros, keeps no line
// numbers and trusts indices, so every statement is checked here first, and what it does not read is picked up.
#pragma once

#include "scene/diagnostics.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tessera::scene {

/// Smoothing group of faces before any `s` statement: they are smoothed, as in a file that has none. Group 0 is `s
/// off`.
inline constexpr std::uint32_t unstated_group = 0xffffffff;

/// A face statement of at least three corners.
struct ObjFaceLine {
    std::uint32_t line = 0;    ///< of the file, from 1
    std::uint32_t number = 0;  ///< among all face statements of the file, from 0
    std::uint32_t smoothing = unstated_group;
};

struct ObjText {
    /// The statements that tinyobjloader is to read, one per line: v, vt, vn, f, g, o, usemtl. All indices are in
    /// range.
    std::string statements;
    std::uint64_t positions = 0;
    std::uint64_t uvs = 0;
    std::uint64_t normals = 0;
    std::uint64_t corners = 0;
    std::vector<ObjFaceLine> faces;      ///< in the order of the f statements above
    std::uint32_t face_statements = 0;   ///< those of fewer than three corners included
    std::vector<std::string> libraries;  ///< arguments of mtllib statements
    /// Positions and normals with a coordinate that is no finite number; from 0, ascending.
    std::vector<std::uint32_t> unusable_positions, unusable_normals;
    /// From the tag lines, in terms of the file: vertices and faces are numbers from 0 over its v and f statements.
    SubdivisionTags tags;
};

/// Throws Error(usage) with line and reason for a statement that makes no sense; skipped ones are noted.
ObjText check_obj_text(std::span<const std::byte> bytes, Diagnostics& diagnostics);

}  // namespace tessera::scene
