// Meshes to write: several parts, awkward numbers, any division into batches.
#pragma once

#include "export/mesh_writer.hpp"

#include <unistd.h>
#include <bit>
#include <filesystem>
#include <random>

namespace tessera::test {

/// A folder of its own, removed with everything in it.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "tessera-export-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder: " + name);
        path_ = name;
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }
    std::size_t entries() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
    }

private:
    std::filesystem::path path_;
};

struct SampleMesh {
    MeshTotals totals;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<Tangent> tangents;             ///< none at first
    std::vector<VertexAttributes> attributes;  ///< likewise
    scene::Scene scene;
};

/// `patches` patches of 4 vertices and 2 triangles, shared out to three parts (the second one empty); every finite
/// float can occur in positions and normals.
inline SampleMesh sample_mesh(std::uint32_t patches) {
    std::mt19937 random(patches);
    const auto any_float = [&] {
        for (;;) {
            const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
            if (std::isfinite(value)) return value;
        }
    };
    SampleMesh mesh;
    for (std::uint32_t i = 0; i < 4 * patches; ++i) {
        const auto uv = [&] { return static_cast<float>(random() % 100000 + 1) * 1e-5f; };
        mesh.vertices.push_back(
            {{any_float(), any_float(), any_float()}, {any_float(), any_float(), -0.0f}, {uv(), uv()}});
    }
    for (std::uint32_t patch = 0; patch < patches; ++patch) {
        for (const std::uint32_t corner : {0, 1, 2, 2, 1, 3})
            mesh.indices.push_back(4 * patch + corner);
    }
    const std::uint64_t first = patches / 3;
    const std::uint64_t rest = patches - first;
    mesh.totals.vertex_count = mesh.vertices.size();
    mesh.totals.index_count = mesh.indices.size();
    mesh.totals.parts = {{"body", 1, 0, 4 * first, 0, 6 * first},
                         {"nothing", 0, 4 * first, 0, 6 * first, 0},
                         {"eyes and ears", 2, 4 * first, 4 * rest, 6 * first, 6 * rest}};
    mesh.scene.materials.resize(3);
    mesh.scene.materials[1].name = "fur";
    mesh.scene.materials[1].base_color = {0.8f, 0.4f, 0.1f, 1.0f};
    mesh.scene.materials[2].base_color = {0.1f, 0.2f, 0.3f, 0.5f};
    mesh.scene.materials[2].alpha_mode = scene::AlphaMode::blend;
    return mesh;
}

/// The same with unit normals and with frames that lean by up to 60 degrees, of either handedness.
inline SampleMesh sample_mesh_with_tangents(std::uint32_t patches) {
    SampleMesh mesh = sample_mesh(patches);
    std::mt19937 random(patches);
    const auto unit = [&](float(&v)[3]) {
        float length = 0.0f;
        while (length < 0.1f || length > 1.0f) {
            for (float& x : v)
                x = static_cast<float>(random() % 20001) * 1e-4f - 1.0f;
            length = std::hypot(v[0], v[1], v[2]);
        }
        for (float& x : v)
            x /= length;
    };
    for (Vertex& vertex : mesh.vertices) {
        unit(vertex.normal);
        const auto along = [&](const float(&v)[3]) {
            return std::abs(v[0] * vertex.normal[0] + v[1] * vertex.normal[1] + v[2] * vertex.normal[2]);
        };
        Tangent frame{};
        do
            unit(frame.tangent);
        while (along(frame.tangent) > 0.86f);
        do
            unit(frame.bitangent);
        while (along(frame.bitangent) > 0.86f);
        frame.handedness = random() % 2 == 0 ? 1.0f : -1.0f;
        mesh.tangents.push_back(frame);
    }
    mesh.totals.has_tangents = true;
    return mesh;
}

/// Gives the mesh any colours.
inline void paint(SampleMesh& mesh) {
    std::mt19937 random(3);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        mesh.attributes.emplace_back();
        for (float& c : mesh.attributes.back().color)
            c = static_cast<float>(random() % 20001) / 20000.0f;
    }
    mesh.totals.has_attributes = true;
    mesh.totals.has_colors = true;
}

/// Appends patches [first, last) as one batch.
inline void append_patches(exporting::MeshWriter& writer, const SampleMesh& mesh, std::size_t first, std::size_t last) {
    writer.append({4 * first,
                   6 * first,
                   std::span(mesh.vertices).subspan(4 * first, 4 * (last - first)),
                   std::span(mesh.indices).subspan(6 * first, 6 * (last - first)),
                   {},
                   mesh.tangents.empty() ? std::span<const Tangent>()
                                         : std::span(mesh.tangents).subspan(4 * first, 4 * (last - first)),
                   mesh.attributes.empty() ? std::span<const VertexAttributes>()
                                           : std::span(mesh.attributes).subspan(4 * first, 4 * (last - first))});
}

/// Writes the whole mesh in batches of `batch` patches.
inline void write_sample(const std::filesystem::path& path, const SampleMesh& mesh, std::size_t batch) {
    const auto writer = exporting::create_mesh_writer(path, mesh.totals, mesh.scene);
    const std::size_t patches = mesh.vertices.size() / 4;
    for (std::size_t first = 0; first < patches; first += batch) {
        append_patches(*writer, mesh, first, std::min(patches, first + batch));
    }
    writer->finish();
}

}  // namespace tessera::test
