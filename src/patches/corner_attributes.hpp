// Colours and tangents of a scene, as patches carry them.
#pragma once

#include "patches/patches.hpp"

namespace tessera::patches {

/// Fills `corner_attributes` of `set`, which otherwise is complete, where a mesh has colours or its material a normal
/// map. Tangents are those of the file, or computed (mikktspace.hpp) where it has none; meshes without a normal map
/// have none. They are kept per corner of a patch and not per control vertex: what MikkTSpace computes may differ
/// between faces that share a vertex, while surfaces need their vertices shared.
void add_corner_attributes(const scene::Scene& scene, PatchSet& set);

}  // namespace tessera::patches
