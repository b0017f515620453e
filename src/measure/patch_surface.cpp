#include "measure/patch_surface.hpp"

#include "base/error.hpp"
#include "tessellate/tessellate.hpp"

#include <fmt/format.h>

namespace tessera::measure {

std::span<const Vertex> PatchSurface::patch_vertices(std::size_t patch) const {
    return std::span(vertices).subspan(first_vertex[patch], first_vertex[patch + 1] - first_vertex[patch]);
}

std::span<const std::uint32_t> PatchSurface::patch_indices(std::size_t patch) const {
    return std::span(indices).subspan(first_index[patch], first_index[patch + 1] - first_index[patch]);
}

PatchSurface make_patch_surface(const gpu::Device& device, const patches::PatchSet& patches,
                                const TessellationOptions& options) {
    const PatchFactors* factors = std::get_if<PatchFactors>(&options.factors);
    if (factors == nullptr) {
        throw Error(ErrorKind::usage, "Surfaces are measured with one set of factors for all patches, not one each.");
    }
    PatchSurface surface;
    const std::span one(factors, 1);
    surface.triangle = make_patterns(device, Domain::triangle, options.partitioning, true, one).front();
    surface.quad = make_patterns(device, Domain::quad, options.partitioning, true, one).front();

    surface.first_vertex.push_back(0);
    surface.first_index.push_back(0);
    for (const patches::PatchCorners& corners : patches.corners) {
        surface.quads.push_back(patches::is_quad(corners));
        const Pattern& pattern = surface.quads.back() ? surface.quad : surface.triangle;
        surface.first_vertex.push_back(surface.first_vertex.back() + pattern.points.size());
        surface.first_index.push_back(surface.first_index.back() + pattern.indices.size());
    }

    RefinedMesh mesh;
    Tessellator(device, patches, options).run(mesh, Space::kernel);
    if (mesh.vertices.size() != surface.first_vertex.back() || mesh.indices.size() != surface.first_index.back()) {
        throw Error(ErrorKind::usage,
                    fmt::format("A surface of {} patches came out with {} vertices where its patterns have {}; factors "
                                "must be positive.",
                                patches.patch_count(), mesh.vertices.size(), surface.first_vertex.back()));
    }
    surface.vertices = std::move(mesh.vertices);
    surface.indices = std::move(mesh.indices);
    return surface;
}

}  // namespace tessera::measure
