// Binary glTF: a header, the JSON, and one binary chunk whose layout is known beforehand. Only the boxes around the
// positions are not, so the JSON is written last, padded with spaces to the room left for it.
#include "base/error.hpp"
#include "base/output_file.hpp"
#include "export/batch_check.hpp"
#include "export/glb_header.hpp"
#include "export/gltf_tangent.hpp"
#include "export/writers.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <stdexcept>

namespace tessera::exporting {
namespace {

static_assert(std::endian::native == std::endian::little, "vertices and indices are written as they are in memory");

constexpr std::uint32_t glb_magic = 0x46546C67, glb_version = 2, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr std::uint64_t file_header_bytes = 12, chunk_header_bytes = 8;
constexpr std::size_t indices_per_piece = 1 << 16, tangents_per_piece = 1 << 14;

struct Bounds {
    std::array<float, 3> min;
    std::array<float, 3> max;
};

class GlbWriter : public MeshWriter {
public:
    GlbWriter(const std::filesystem::path& path, const MeshTotals& totals, const scene::Scene& scene)
        : check_(totals, path.string()),
          header_(path.string(), path.stem().string(), totals, scene),
          bounds_(totals.parts.size()),
          json_bytes_((header_.text().size() + 3) / 4 * 4),
          binary_at_(file_header_bytes + chunk_header_bytes + json_bytes_ + chunk_header_bytes),
          file_bytes_(header_.binary_bytes() > 0 ? binary_at_ + header_.binary_bytes()
                                                 : binary_at_ - chunk_header_bytes),
          file_(checked_size(path, file_bytes_)) {
        constexpr float huge = std::numeric_limits<float>::infinity();
        for (Bounds& bounds : bounds_)
            bounds = {{huge, huge, huge}, {-huge, -huge, -huge}};
        for (const GlbImage& image : header_.images()) {
            const std::vector<std::byte>& bytes = scene.images[image.image].encoded;
            file_.write_at(binary_at_ + image.offset, bytes);
            const std::array<std::byte, 4> zeros{};
            file_.write_at(binary_at_ + image.offset + bytes.size(),
                           std::span(zeros).first((4 - bytes.size() % 4) % 4));
        }
    }

    void append(const MeshBatch& batch) override {
        check_.accept(batch);
        if (header_.binary_bytes() == 0) return;  // vertices without any triangle: an empty scene
        file_.write_at(binary_at_ + batch.first_vertex * sizeof(Vertex), std::as_bytes(batch.vertices));
        write_tangents(batch);
        write_colors(batch);
        for_each_part(check_.totals(), &MeshPart::first_vertex, &MeshPart::vertex_count, batch.first_vertex,
                      batch.vertices.size(), [&](std::size_t part, std::uint64_t first, std::uint64_t count) {
                          extend(bounds_[part], batch.vertices.subspan(first - batch.first_vertex, count));
                      });
        for_each_part(check_.totals(), &MeshPart::first_index, &MeshPart::index_count, batch.first_index,
                      batch.indices.size(), [&](std::size_t part, std::uint64_t first, std::uint64_t count) {
                          write_indices(part, first, batch.indices.subspan(first - batch.first_index, count));
                      });
    }

    void finish() override {
        check_.finish();
        for (std::size_t i = 0; i < bounds_.size(); ++i)
            header_.set_bounds(i, bounds_[i].min, bounds_[i].max);
        std::string json = header_.text();
        if (json.size() > json_bytes_) throw std::logic_error("the JSON of a .glb outgrew its room");
        json.resize(json_bytes_, ' ');
        write_words(0, {glb_magic, glb_version, static_cast<std::uint32_t>(file_bytes_),
                        static_cast<std::uint32_t>(json_bytes_), json_chunk});
        file_.write_at(file_header_bytes + chunk_header_bytes, std::as_bytes(std::span(json)));
        if (header_.binary_bytes() > 0) {
            write_words(binary_at_ - chunk_header_bytes,
                        {static_cast<std::uint32_t>(header_.binary_bytes()), binary_chunk});
        }
        file_.publish();
    }

private:
    static const std::filesystem::path& checked_size(const std::filesystem::path& path, std::uint64_t bytes) {
        constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
        if (bytes <= most) return path;
        throw Error(ErrorKind::output, fmt::format("Cannot write '{}': it would be {} bytes, but a .glb holds {} at "
                                                   "most; lower the tessellation factor or write .ply.",
                                                   path.string(), bytes, most));
    }

    static void extend(Bounds& bounds, std::span<const Vertex> vertices) {
        for (const Vertex& vertex : vertices) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                bounds.min[axis] = std::min(bounds.min[axis], vertex.position[axis]);
                bounds.max[axis] = std::max(bounds.max[axis], vertex.position[axis]);
            }
        }
    }

    void write_tangents(const MeshBatch& batch) {
        for (std::size_t first = 0; first < batch.tangents.size(); first += tangents_.size()) {
            tangents_.resize(std::min(tangents_per_piece, batch.tangents.size() - first));
            for (std::size_t i = 0; i < tangents_.size(); ++i)
                tangents_[i] = gltf_tangent(batch.vertices[first + i], batch.tangents[first + i]);
            file_.write_at(binary_at_ + header_.tangents_at() + (batch.first_vertex + first) * sizeof(GltfTangent),
                           std::as_bytes(std::span(tangents_)));
        }
    }

    void write_colors(const MeshBatch& batch) {
        if (!check_.totals().has_colors) return;
        for (std::size_t first = 0; first < batch.attributes.size(); first += colors_.size()) {
            const auto piece =
                batch.attributes.subspan(first, std::min(tangents_per_piece, batch.attributes.size() - first));
            colors_.resize(piece.size());
            std::ranges::transform(piece, colors_.begin(), [](const VertexAttributes& a) {
                return std::array{a.color[0], a.color[1], a.color[2], a.color[3]};
            });
            file_.write_at(binary_at_ + header_.colors_at() + (batch.first_vertex + first) * sizeof(colors_[0]),
                           std::as_bytes(std::span(colors_)));
        }
    }

    void write_indices(std::size_t part, std::uint64_t at, std::span<const std::uint32_t> indices) {
        const auto base = static_cast<std::uint32_t>(check_.totals().parts[part].first_vertex);
        while (!indices.empty()) {
            const auto piece = indices.first(std::min(indices.size(), indices_per_piece));
            local_.resize(piece.size());
            std::transform(piece.begin(), piece.end(), local_.begin(), [&](std::uint32_t i) { return i - base; });
            file_.write_at(binary_at_ + header_.indices_at() + at * sizeof(std::uint32_t),
                           std::as_bytes(std::span(local_)));
            at += piece.size();
            indices = indices.subspan(piece.size());
        }
    }

    void write_words(std::uint64_t at, std::initializer_list<std::uint32_t> words) {
        file_.write_at(at, std::as_bytes(std::span(words.begin(), words.size())));
    }

    BatchCheck check_;
    GlbHeader header_;
    std::vector<Bounds> bounds_;  // per part
    std::uint64_t json_bytes_;
    std::uint64_t binary_at_;
    std::uint64_t file_bytes_;
    OutputFile file_;
    std::vector<std::uint32_t> local_;
    std::vector<GltfTangent> tangents_;
    std::vector<std::array<float, 4>> colors_;
};

}  // namespace

std::unique_ptr<MeshWriter> create_glb_writer(const std::filesystem::path& path, const MeshTotals& totals,
                                              const scene::Scene& materials) {
    return std::make_unique<GlbWriter>(path, totals, materials);
}

}  // namespace tessera::exporting
