// Writes a refined mesh as .glb, .obj or .ply, batch by batch, so that memory does not grow with the mesh.
#pragma once

#include "scene/scene.hpp"
#include "tessellate/refined_mesh.hpp"

#include <filesystem>
#include <memory>

namespace tessera::exporting {

/// A file being written. It grows under a temporary name beside `path` and is renamed by finish(); without finish()
/// (an exception, say) the temporary file is removed and `path` stays as it was.
class MeshWriter : public MeshSink {
public:
    /// Takes the next batch. Throws Error(output) where it cannot be written or a vertex is not finite (infinity, NaN),
    /// and std::logic_error where the batch contradicts the totals. After a throw the writer can only be destroyed.
    void append(const MeshBatch& batch) override = 0;

    /// Completes the file under its final name; call it once, after everything announced in the totals has come.
    /// Throws like append().
    virtual void finish() = 0;
};

/// Chooses the format by extension (.glb, .obj, .ply; case ignored):
/// - .glb: glTF 2.0, one mesh with a primitive per part that has triangles, the materials those use, and the base
///   colour images as they stood in the input; quads by FB_ngon_encoding; tangents as TANGENT (glTF 2.0, section
///   3.7.2.1), turned to a right angle with the vertex normal, see gltf_tangent(); colours as COLOR_0;
/// - .obj: an object per part, materials (colours only, no textures) in a .mtl beside it; texture coordinates have
///   their origin at the lower left there, so v is written as 1 - v;
/// - .ply: binary little-endian, x y z nx ny nz s t, one mesh without materials; texture coordinates as they are;
///   tangents as tx ty tz tw bx by bz, where tw is the handedness, colours as red green blue alpha, linear. Its header
///   counts the faces, which are not known beforehand where there are quads: those are refused.
/// Tangents are refused for .obj, which has no place for them; colours are left out there.
/// Every number reads back to the same bits (1 - v: read as a double, for v of a magnitude from 2^-28 to 2^28).
/// `materials` gives the materials the parts refer to, and the images; it
/// need not outlive the call.
/// Sizes that the format cannot hold (4 GiB for .glb, 2^32 vertices) are refused here. Throws Error(usage) for an
/// unknown extension, a .ply with quads or an .obj with tangents, Error(output) where the file cannot be made or
/// written, std::logic_error for totals whose parts do not add up or name no material.
std::unique_ptr<MeshWriter> create_mesh_writer(const std::filesystem::path& path, const MeshTotals& totals,
                                               const scene::Scene& materials);

}  // namespace tessera::exporting
