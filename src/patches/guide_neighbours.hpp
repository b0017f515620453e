// Which guides of hair stand beside each other.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace tessera::patches {

/// Stands for the guides that a patch lacks to three.
inline constexpr std::uint32_t no_guide = 0xffffffffu;

/// Three guides with hair between them; or two, or one, the others being no_guide.
using HairPatch = std::array<std::uint32_t, 3>;

/// Patches over all guides, in ascending order of the guides. Three guides make one where the smallest sphere through
/// their roots holds no other root (a Gabriel simplex): in a plane these are the triangles of Delaunay, on a skin
/// nearly so, and they do not overlap. A guide that is in no triangle, as in a row, makes pairs by the same rule; one
/// that is alone stays alone. Normals (one per root, zero for none) keep guides apart that grow on opposite sides of
/// something thin. The result depends on nothing but the numbers.
std::vector<HairPatch> neighbouring_guides(std::span<const glm::vec3> roots, std::span<const glm::vec3> normals);

}  // namespace tessera::patches
