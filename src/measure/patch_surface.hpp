// A tessellated surface that can be looked into patch by patch.
#pragma once

#include "gpu/device.hpp"
#include "patches/patches.hpp"
#include "tessellate/options.hpp"
#include "tessellate/pattern.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera::measure {

/// All patches have the same factors, so that the patches of a domain share a pattern, and two surfaces of one patch
/// set made with equal factors and partitioning have the same domain point under each vertex. Positions are those of
/// kernel space, where the largest coordinate of the model is near 1.
struct PatchSurface {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;       ///< of vertices, three per triangle
    std::vector<bool> quads;                  ///< of each patch: whether it is one
    std::vector<std::uint64_t> first_vertex;  ///< of each patch, and the total
    std::vector<std::uint64_t> first_index;   ///< likewise
    Pattern triangle, quad;                   ///< domain points in the order of a patch's vertices

    std::size_t patch_count() const { return quads.size(); }
    std::size_t triangle_count() const { return indices.size() / 3; }
    const Pattern& pattern(std::size_t patch) const { return quads[patch] ? quad : triangle; }
    std::span<const Vertex> patch_vertices(std::size_t patch) const;
    std::span<const std::uint32_t> patch_indices(std::size_t patch) const;
};

/// `options.factors` holds one set of positive factors. Throws Error(usage) where it holds more, and as tessellate()
/// does.
PatchSurface make_patch_surface(const gpu::Device& device, const patches::PatchSet& patches,
                                const TessellationOptions& options);

}  // namespace tessera::measure
