// The writers behind create_mesh_writer(), one per format.
#pragma once

#include "export/mesh_writer.hpp"

namespace tessera::exporting {

std::unique_ptr<MeshWriter> create_glb_writer(const std::filesystem::path& path, const MeshTotals& totals,
                                              const scene::Scene& materials);
std::unique_ptr<MeshWriter> create_obj_writer(const std::filesystem::path& path, const MeshTotals& totals,
                                              const scene::Scene& materials);
std::unique_ptr<MeshWriter> create_ply_writer(const std::filesystem::path& path, const MeshTotals& totals);

}  // namespace tessera::exporting
