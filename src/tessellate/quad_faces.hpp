// Quads among the triangles of a patch: the cells of its pattern that are a regular grid.
#pragma once

#include <cstdint>
#include <span>

namespace tessera {

/// Words of a patch record (kernels/layout.h).
using RecordView = std::span<const std::uint32_t, 8>;

/// Puts a patch's triangles into an order in which the two halves of a quad follow each other as (a, b, c), (a, c, d),
/// and sets `quads` to 1 at the first of them, to 0 elsewhere; the triangles themselves stay, but for the corner they
/// begin with. A quad is a cell of the grid that the inside factors of a quad domain make; along an edge whose factor
/// makes as many points as the inside factor the grid reaches the edge, along others a row of triangles leads over.
/// Neighbouring faces of the list begin with different corners, as FB_ngon_encoding wants it.
///
/// `indices` are those of one patch whose first vertex is `first_vertex`, `quads` has one element per triangle.
void mark_quads(RecordView record, std::uint32_t first_vertex, std::span<std::uint32_t> indices,
                std::span<std::uint8_t> quads);

}  // namespace tessera
