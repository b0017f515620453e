// Binary PLY: a text header, the vertices as they are in memory, then the faces. The header gives all sizes, so both
// regions fill at known offsets.
#include "base/output_file.hpp"
#include "export/batch_check.hpp"
#include "export/writers.hpp"

#include <fmt/format.h>
#include <bit>
#include <cstddef>
#include <cstring>

namespace tessera::exporting {
namespace {

static_assert(std::endian::native == std::endian::little, "vertices are written as they are in memory");

constexpr std::size_t face_bytes = 1 + 3 * sizeof(std::uint32_t);
constexpr std::size_t faces_per_piece = 1 << 14, vertices_per_piece = 1 << 14;
constexpr std::size_t tangent_bytes = offsetof(Tangent, unused);  // tx ty tz tw bx by bz
static_assert(tangent_bytes == 7 * sizeof(float));

class PlyWriter : public MeshWriter {
public:
    PlyWriter(const std::filesystem::path& path, const MeshTotals& totals)
        : check_(totals, path.string()),
          file_(path),
          vertex_bytes_(sizeof(Vertex) + (totals.has_tangents ? tangent_bytes : 0)) {
        const std::string header = fmt::format(
            "ply\nformat binary_little_endian 1.0\ncomment Tessera {}\nelement vertex {}\n"
            "property float x\nproperty float y\nproperty float z\n"
            "property float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n{}"
            "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
            TESSERA_VERSION, totals.vertex_count,
            totals.has_tangents ? "property float tx\nproperty float ty\nproperty float tz\nproperty float tw\n"
                                  "property float bx\nproperty float by\nproperty float bz\n"
                                : "",
            totals.index_count / 3);
        file_.write_at(0, std::as_bytes(std::span(header)));
        vertices_at_ = header.size();
        faces_at_ = vertices_at_ + totals.vertex_count * vertex_bytes_;
    }

    void append(const MeshBatch& batch) override {
        check_.accept(batch);
        if (batch.tangents.empty()) {
            file_.write_at(vertices_at_ + batch.first_vertex * sizeof(Vertex), std::as_bytes(batch.vertices));
        }
        for (std::size_t first = 0; first < batch.tangents.size(); first += vertices_per_piece) {
            const std::size_t count = std::min(vertices_per_piece, batch.tangents.size() - first);
            pack_vertices(batch.vertices.subspan(first, count), batch.tangents.subspan(first, count));
            file_.write_at(vertices_at_ + (batch.first_vertex + first) * vertex_bytes_, piece_);
        }
        std::uint64_t at = faces_at_ + batch.first_index / 3 * face_bytes;
        for (std::size_t first = 0; first < batch.indices.size(); first += 3 * faces_per_piece) {
            const std::size_t count = std::min(3 * faces_per_piece, batch.indices.size() - first);
            pack_faces(batch.indices.subspan(first, count));
            file_.write_at(at, piece_);
            at += piece_.size();
        }
    }

    void finish() override {
        check_.finish();
        file_.publish();
    }

private:
    void pack_vertices(std::span<const Vertex> vertices, std::span<const Tangent> tangents) {
        piece_.resize(vertices.size() * vertex_bytes_);
        std::byte* to = piece_.data();
        for (std::size_t i = 0; i < vertices.size(); ++i, to += vertex_bytes_) {
            std::memcpy(to, &vertices[i], sizeof(Vertex));
            std::memcpy(to + sizeof(Vertex), &tangents[i], tangent_bytes);
        }
    }

    void pack_faces(std::span<const std::uint32_t> indices) {
        piece_.resize(indices.size() / 3 * face_bytes);
        std::byte* to = piece_.data();
        for (std::size_t i = 0; i < indices.size(); i += 3, to += face_bytes) {
            to[0] = std::byte{3};
            std::memcpy(to + 1, &indices[i], face_bytes - 1);
        }
    }

    BatchCheck check_;
    OutputFile file_;
    std::uint64_t vertex_bytes_;
    std::uint64_t vertices_at_ = 0;
    std::uint64_t faces_at_ = 0;
    std::vector<std::byte> piece_;
};

}  // namespace

std::unique_ptr<MeshWriter> create_ply_writer(const std::filesystem::path& path, const MeshTotals& totals) {
    return std::make_unique<PlyWriter>(path, totals);
}

}  // namespace tessera::exporting
