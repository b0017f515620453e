#include "export/mesh_writer.hpp"

#include "base/error.hpp"
#include "export/writers.hpp"

#include <fmt/format.h>
#include <stdexcept>

namespace tessera::exporting {
namespace {

/// The extension with A to Z as small letters, whatever the locale.
std::string lower_case_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return extension;
}

void check_limits(const std::filesystem::path& path, const MeshTotals& totals, const scene::Scene& materials) {
    constexpr std::uint64_t most_vertices = std::uint64_t{1} << 32;
    constexpr std::uint64_t most_indices = std::uint64_t{1} << 58;  // keeps file offsets far from overflow
    if (totals.vertex_count > most_vertices || totals.index_count > most_indices) {
        throw Error(ErrorKind::output,
                    fmt::format("Cannot write '{}': {} vertices and {} indices are more than 32-bit indices can "
                                "address; lower the tessellation factor.",
                                path.string(), totals.vertex_count, totals.index_count));
    }
    for (const MeshPart& part : totals.parts) {
        if (part.material >= materials.materials.size()) {
            throw std::logic_error(
                fmt::format("part '{}' names material {} of {}", part.name, part.material, materials.materials.size()));
        }
    }
}

}  // namespace

std::unique_ptr<MeshWriter> create_mesh_writer(const std::filesystem::path& path, const MeshTotals& totals,
                                               const scene::Scene& materials) {
    const std::string extension = lower_case_extension(path);
    if (extension != ".glb" && extension != ".obj" && extension != ".ply") {
        throw Error(ErrorKind::usage, fmt::format("Cannot write '{}': the extension '{}' names no format of this "
                                                  "program; use .glb, .obj or .ply.",
                                                  path.string(), extension));
    }
    if (extension == ".ply" && totals.has_quads) {
        throw Error(ErrorKind::usage, fmt::format("Cannot write '{}': quads go into .obj and .glb files only; write "
                                                  "triangles, or choose one of those.",
                                                  path.string()));
    }
    if (extension == ".obj" && totals.has_tangents) {
        throw Error(ErrorKind::usage, fmt::format("Cannot write '{}': an .obj has no place for tangents; leave them "
                                                  "out, or write .glb or .ply.",
                                                  path.string()));
    }
    check_limits(path, totals, materials);
    if (extension == ".glb") return create_glb_writer(path, totals, materials);
    if (extension == ".obj") return create_obj_writer(path, totals, materials);
    return create_ply_writer(path, totals);
}

}  // namespace tessera::exporting
