// How the faces of meshes hang together, and what is amiss there.
#pragma once

#include "scene/diagnostics.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <span>

namespace tessera::scene {

/// Vertices that no face uses. They are kept, as the file has them, and make no difference to any surface.
std::size_t count_unused_vertices(const Mesh& mesh);

/// Edges that more than two faces of `meshes` together use; vertices at bitwise equal positions count as one. The
/// surface is not a manifold there: it is kept, but more than two patches meet.
std::size_t count_crowded_edges(std::span<const Mesh> meshes);

/// Faces without area: corners in one place or on one line. They are kept, for an edge of a neighbour may need them.
std::size_t count_flat_faces(std::span<const Mesh> meshes);

/// The sentences about them, where there are any.
void note_unused_vertices(std::size_t count, Diagnostics& diagnostics);
void note_crowded_edges(std::size_t count, Diagnostics& diagnostics);
void note_flat_faces(std::size_t count, Diagnostics& diagnostics);

}  // namespace tessera::scene
