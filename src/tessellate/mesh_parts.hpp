// What Tessellator and HairTessellator share: the part of the output made from each mesh of the scene, and its scale.
#pragma once

#include "patches/patches.hpp"
#include "tessellate/plan.hpp"
#include "tessellate/refined_mesh.hpp"

#include <span>

namespace tessera {

/// Adds the output of a chunk, which begins at `offsets` (one per element of the chunk, and the end), to the parts its
/// patches belong to. `totals` has a part for each range; an element is one of `per_patch` equal shares of a patch.
void add_to_parts(MeshTotals& totals, std::span<const patches::PatchRange> ranges, std::uint64_t per_patch,
                  const Chunk& chunk, std::span<const PatchOffset> offsets);

/// Says where each part begins, once all are counted, and how large they are together.
void place_parts(MeshTotals& totals);

/// Takes positions from the space of the kernels into that of the model, whose scale is 2^exponent.
void scale_to_model(std::span<Vertex> vertices, int exponent);

}  // namespace tessera
