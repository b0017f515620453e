#include "tessellate/job_input.hpp"

#include "base/error.hpp"
#include "tessellate/ring_table.hpp"

#include <fmt/format.h>
#include <algorithm>

namespace tessera {
namespace {

static_assert(sizeof(patches::VertexTags) == VERTEX_TAG_FLOATS * sizeof(float));
static_assert(sizeof(patches::CornerTags) == CORNER_TAG_FLOATS * sizeof(float));

/// How many tags the scheme reads: of each control vertex, or one for all; none where it reads none.
std::size_t vertex_tag_count(const patches::PatchSet& patches, const TessellationOptions& options) {
    if (options.scheme != Scheme::phong && options.scheme != Scheme::stpn) return 0;
    return std::max<std::size_t>(patches.vertex_tags.size(), 1);
}

}  // namespace

std::vector<patches::VertexTags> vertex_tags(const patches::PatchSet& patches, const TessellationOptions& options) {
    std::vector<patches::VertexTags> tags = patches.vertex_tags;
    tags.resize(vertex_tag_count(patches, options));
    // An alpha under 2^-24 changes nothing but could make denormals.
    const float alpha = options.alpha < 0x1p-24f ? 0.0f : options.alpha;
    for (patches::VertexTags& t : tags)
        t.alpha = t.alpha < 0.0f ? alpha : t.alpha;
    return tags;
}

std::uint64_t shared_bytes(const patches::PatchSet& patches, const TessellationOptions& options) {
    return patches.control_vertices.size() * sizeof(Vertex) +
           vertex_tag_count(patches, options) * sizeof(patches::VertexTags) + ring_table_bytes();
}

std::array<patches::CornerTags, PATCH_CORNERS> smooth_corners(const patches::PatchSet& patches, std::uint64_t patch) {
    std::array<patches::CornerTags, PATCH_CORNERS> tags{};
    const patches::PatchCorners& corners = patches.corners[patch];
    for (std::size_t k = 0; k < (patches::is_quad(corners) ? 4u : 3u); ++k)
        std::ranges::copy(patches.control_vertices[corners[k]].normal, tags[k].normal);
    return tags;
}

void check_job(const patches::PatchSet& patches, const TessellationOptions& options, const gpu::Limits& limits) {
    if (const auto* factors = std::get_if<std::vector<PatchFactors>>(&options.factors);
        factors != nullptr && factors->size() != patches.patch_count()) {
        throw Error(ErrorKind::usage, fmt::format("There are {} sets of tessellation factors for {} patches; give one "
                                                  "set, or one per patch.",
                                                  factors->size(), patches.patch_count()));
    }
    if (!(options.alpha >= 0.0f && options.alpha <= 1.0f)) {
        throw Error(ErrorKind::usage,
                    fmt::format("The shape factor alpha is {}; it must lie in [0, 1].", options.alpha));
    }
    if (!patches.vertex_tags.empty() && patches.vertex_tags.size() != patches.control_vertices.size()) {
        throw Error(ErrorKind::usage,
                    fmt::format("There are tags of {} vertices for {} control vertices; give none, or "
                                "one per vertex.",
                                patches.vertex_tags.size(), patches.control_vertices.size()));
    }
    if (!patches.corner_tags.empty() && patches.corner_tags.size() != patches.patch_count()) {
        throw Error(ErrorKind::usage,
                    fmt::format("There are corner tags of {} patches for {} patches; give none, or one "
                                "set per patch.",
                                patches.corner_tags.size(), patches.patch_count()));
    }
    const std::uint64_t bytes =
        std::max<std::uint64_t>(patches.control_vertices.size() * sizeof(Vertex),
                                vertex_tag_count(patches, options) * sizeof(patches::VertexTags));
    if (bytes > limits.max_storage_binding_size) {
        throw Error(ErrorKind::usage,
                    fmt::format("The model has {} control vertices ({} bytes), more than one binding "
                                "of the device holds ({} bytes); split the model.",
                                patches.control_vertices.size(), bytes, limits.max_storage_binding_size));
    }
}

}  // namespace tessera
