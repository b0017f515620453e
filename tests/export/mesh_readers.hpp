// Small readers of the three formats, written apart from the writers: they take what the formats' definitions say, and
// throw on anything else.
#pragma once

#include "tessellate/refined_mesh.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace tessera::test {

struct ReadPart {
    std::string name;
    std::string material;
    std::vector<std::uint32_t> indices;  ///< into ReadMesh::vertices
};

struct ReadMesh {
    std::vector<Vertex> vertices;
    std::vector<ReadPart> parts;
    std::vector<std::array<float, 4>> tangents;    ///< of .glb and .ply files that have them
    std::vector<std::array<float, 3>> bitangents;  ///< of .ply files that have them
    std::vector<std::array<float, 4>> colors;      ///< of .glb and .ply files that have them
};

struct GlbFile {
    nlohmann::json json;
    std::string binary;
};

std::string read_bytes(const std::filesystem::path& path);
GlbFile read_glb_file(const std::filesystem::path& path);

ReadMesh read_glb(const std::filesystem::path& path);
ReadMesh read_obj(const std::filesystem::path& path);
ReadMesh read_ply(const std::filesystem::path& path);

/// By extension.
ReadMesh read_mesh(const std::filesystem::path& path);

}  // namespace tessera::test
