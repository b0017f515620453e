#include "export/batch_check.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace tessera::exporting {
namespace {

void require_equal(const char* what, std::uint64_t expected, std::uint64_t found) {
    if (expected != found) throw std::logic_error(fmt::format("{}: expected {}, found {}", what, expected, found));
}

}  // namespace

BatchCheck::BatchCheck(const MeshTotals& totals, std::string file) : totals_(totals), file_(std::move(file)) {
    std::uint64_t vertices = 0;
    std::uint64_t indices = 0;
    for (const MeshPart& part : totals_.parts) {
        require_equal("first vertex of a part", vertices, part.first_vertex);
        require_equal("first index of a part", indices, part.first_index);
        require_equal("indices of a part beyond whole triangles", 0, part.index_count % 3);
        vertices += part.vertex_count;
        indices += part.index_count;
    }
    require_equal("vertices of all parts", totals_.vertex_count, vertices);
    require_equal("indices of all parts", totals_.index_count, indices);
}

void BatchCheck::accept(const MeshBatch& batch) {
    require_equal("first vertex of a batch", vertices_, batch.first_vertex);
    require_equal("first index of a batch", indices_, batch.first_index);
    require_equal("indices of a batch beyond whole triangles", 0, batch.indices.size() % 3);
    if (batch.vertices.size() > totals_.vertex_count - vertices_ ||
        batch.indices.size() > totals_.index_count - indices_) {
        throw std::logic_error(fmt::format(
            "a batch exceeds the totals: {} vertices at {} of {}, {} indices at {} of {}", batch.vertices.size(),
            vertices_, totals_.vertex_count, batch.indices.size(), indices_, totals_.index_count));
    }
    require_equal("tangents of a batch", totals_.has_tangents ? batch.vertices.size() : 0, batch.tangents.size());
    require_equal("attributes of a batch", totals_.has_attributes ? batch.vertices.size() : 0, batch.attributes.size());
    check_indices(batch);
    check_quads(batch);
    check_finite(batch);
    vertices_ += batch.vertices.size();
    indices_ += batch.indices.size();
}

void BatchCheck::check_indices(const MeshBatch& batch) const {
    for_each_part(totals_, &MeshPart::first_index, &MeshPart::index_count, batch.first_index, batch.indices.size(),
                  [&](std::size_t number, std::uint64_t first, std::uint64_t count) {
                      const MeshPart& part = totals_.parts[number];
                      std::uint32_t low = std::numeric_limits<std::uint32_t>::max();
                      std::uint32_t high = 0;
                      for (const std::uint32_t index : batch.indices.subspan(first - batch.first_index, count)) {
                          low = std::min(low, index);
                          high = std::max(high, index);
                      }
                      const std::uint64_t begin = std::max(part.first_vertex, batch.first_vertex);
                      const std::uint64_t end =
                          std::min(part.first_vertex + part.vertex_count, batch.first_vertex + batch.vertices.size());
                      if (low < begin || high >= end) {
                          throw std::logic_error(
                              fmt::format("a batch uses vertices {} to {}, but has {} up to {} of "
                                          "part {}",
                                          low, high, begin, end, number));
                      }
                  });
}

void BatchCheck::check_quads(const MeshBatch& batch) const {
    require_equal("marks of quads", totals_.has_quads ? batch.indices.size() / 3 : 0, batch.quads.size());
    for_each_part(
        totals_, &MeshPart::first_index, &MeshPart::index_count, batch.first_index, batch.indices.size(),
        [&](std::size_t, std::uint64_t first, std::uint64_t count) {
            const std::size_t begin = (first - batch.first_index) / 3;
            const std::size_t end = batch.quads.empty() ? begin : begin + count / 3;
            for (std::size_t t = begin; t < end; ++t) {
                if (batch.quads[t] == 0) continue;
                const std::uint32_t* half = &batch.indices[3 * t];
                if (t + 1 == end || batch.quads[t + 1] != 0 || half[3] != half[0] || half[4] != half[2]) {
                    throw std::logic_error(fmt::format("triangle {} of a batch is not the first half of a quad", t));
                }
                ++t;
            }
        });
}

void BatchCheck::check_finite(const MeshBatch& batch) const {
    for (std::size_t i = 0; i < batch.vertices.size(); ++i) {
        const Vertex& v = batch.vertices[i];
        // Products with zero are zero for finite numbers and NaN for all others: one test for the eight of them.
        const float sum = 0.0f * v.position[0] + 0.0f * v.position[1] + 0.0f * v.position[2] + 0.0f * v.normal[0] +
                          0.0f * v.normal[1] + 0.0f * v.normal[2] + 0.0f * v.uv[0] + 0.0f * v.uv[1];
        if (std::isnan(sum)) {
            throw Error(
                ErrorKind::output,
                fmt::format("Cannot write '{}': vertex {} is not finite: position ({}, {}, {}), normal ({}, {}, "
                            "{}), uv ({}, {}); the model's coordinates are too large.",
                            file_, batch.first_vertex + i, v.position[0], v.position[1], v.position[2], v.normal[0],
                            v.normal[1], v.normal[2], v.uv[0], v.uv[1]));
        }
    }
    for (std::size_t i = 0; i < batch.tangents.size(); ++i) {
        const Tangent& t = batch.tangents[i];
        const float sum = 0.0f * t.tangent[0] + 0.0f * t.tangent[1] + 0.0f * t.tangent[2] + 0.0f * t.bitangent[0] +
                          0.0f * t.bitangent[1] + 0.0f * t.bitangent[2];
        if (std::isnan(sum) || std::abs(t.handedness) != 1.0f) {
            throw Error(ErrorKind::output,
                        fmt::format("Cannot write '{}': the tangent of vertex {} is ({}, {}, {}), its handedness {}, "
                                    "its bitangent ({}, {}, {}); they must be finite, and the handedness 1 or -1.",
                                    file_, batch.first_vertex + i, t.tangent[0], t.tangent[1], t.tangent[2],
                                    t.handedness, t.bitangent[0], t.bitangent[1], t.bitangent[2]));
        }
    }
    for (std::size_t i = 0; i < batch.attributes.size(); ++i) {
        const float(&c)[4] = batch.attributes[i].color;
        const float sum = 0.0f * c[0] + 0.0f * c[1] + 0.0f * c[2] + 0.0f * c[3];
        if (std::isnan(sum)) {
            throw Error(
                ErrorKind::output,
                fmt::format("Cannot write '{}': the colour of vertex {} is ({}, {}, {}, {}); it must be finite.", file_,
                            batch.first_vertex + i, c[0], c[1], c[2], c[3]));
        }
    }
}

void BatchCheck::finish() const {
    require_equal("vertices written", totals_.vertex_count, vertices_);
    require_equal("indices written", totals_.index_count, indices_);
}

}  // namespace tessera::exporting
