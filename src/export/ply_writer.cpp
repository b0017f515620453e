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
constexpr std::size_t bytes_per_color = sizeof(VertexAttributes::color);

class PlyWriter : public MeshWriter {
public:
    PlyWriter(const std::filesystem::path& path, const MeshTotals& totals)
        : check_(totals, path.string()),
          file_(path),
          vertex_bytes_(sizeof(Vertex) + (totals.has_tangents ? tangent_bytes : 0) +
                        (totals.has_colors ? bytes_per_color : 0)) {
        const std::string header = fmt::format(
            "ply\nformat binary_little_endian 1.0\ncomment Tessera {}\nelement vertex {}\n"
            "property float x\nproperty float y\nproperty float z\n"
            "property float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n{}{}"
            "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
            TESSERA_VERSION, totals.vertex_count,
            totals.has_tangents ? "property float tx\nproperty float ty\nproperty float tz\nproperty float tw\n"
                                  "property float bx\nproperty float by\nproperty float bz\n"
                                : "",
            totals.has_colors ? "property float red\nproperty float green\nproperty float blue\nproperty float alpha\n"
                              : "",
            totals.index_count / 3);
        file_.write_at(0, std::as_bytes(std::span(header)));
        vertices_at_ = header.size();
        faces_at_ = vertices_at_ + totals.vertex_count * vertex_bytes_;
    }

    void append(const MeshBatch& batch) override {
        check_.accept(batch);
        if (vertex_bytes_ == sizeof(Vertex)) {
            file_.write_at(vertices_at_ + batch.first_vertex * sizeof(Vertex), std::as_bytes(batch.vertices));
        } else {
            for (std::size_t first = 0; first < batch.vertices.size(); first += vertices_per_piece) {
                pack_vertices(batch, first, std::min(vertices_per_piece, batch.vertices.size() - first));
                file_.write_at(vertices_at_ + (batch.first_vertex + first) * vertex_bytes_, piece_);
            }
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
    /// Vertices [first, first + count) of a batch.
    void pack_vertices(const MeshBatch& batch, std::size_t first, std::size_t count) {
        piece_.resize(count * vertex_bytes_);
        std::byte* to = piece_.data();
        const auto put = [&to](const void* from, std::size_t bytes) {
            std::memcpy(to, from, bytes);
            to += bytes;
        };
        for (std::size_t i = first; i < first + count; ++i) {
            put(&batch.vertices[i], sizeof(Vertex));
            if (check_.totals().has_tangents) put(&batch.tangents[i], tangent_bytes);
            if (check_.totals().has_colors) put(batch.attributes[i].color, bytes_per_color);
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
