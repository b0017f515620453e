// The kernels held against a device's own tessellation stage.
#pragma once

#include "gpu/device.hpp"
#include "patches/patches.hpp"
#include "tessellate/pattern.hpp"
#include "verify/fixed_function.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace tessera::verify {

/// Patterns against the stage: which triangles or segments, and their winding.
struct DomainComparison {
    std::uint64_t patches = 0;
    std::uint64_t primitives = 0;      ///< triangles or segments that the kernels made
    std::uint64_t differing = 0;       ///< patches
    std::optional<std::string> first;  ///< a sentence about the first patch that differs

    bool equal() const { return differing == 0; }
};

/// Tessellates every set of factors on both. They agree on a patch where the captured coordinates are multiples of
/// 2^-16 with w = 1 - u - v exactly (0 off triangles), and the triangles are the same as a multiset, each up to where
/// it starts; segments, whichever end comes first. The order of triangles is the stage's own affair in Vulkan, and so
/// is whether a patch lives whose outer factor is a positive denormal (lavapipe flushes it to zero, which culls).
/// Throws Error(usage) for pow2 and uniform, which Vulkan has no spacing for.
DomainComparison compare_domain(FixedFunctionTessellator& stage, const gpu::Device& device, Domain domain,
                                Partitioning partitioning, bool clockwise, std::span<const PatchFactors> factors);

/// Two implementations of a surface that share no code round differently, each result by some units in the last place
/// of its largest terms. So the error of a position is given relative to the largest coordinate of its patch's corners,
/// and the error of a unit normal, which grows as the blended normal gets short, times that one's length.
/// The bounds are 16 roundings, of 2^-24 each. The largest errors seen on lavapipe, in 10^8 vertices: 4.7e-7 for
/// positions (pn; 3.3e-7 phong, 0 linear), 2.0e-7 for normals.
inline constexpr double position_error_bound = 0x1p-20;
inline constexpr double normal_error_bound = 0x1p-20;

/// Vertices against the stage.
struct SurfaceComparison {
    std::uint64_t patches = 0;
    std::uint64_t vertices = 0;        ///< captured ones that were compared
    double position_error = 0.0;       ///< the largest
    double normal_error = 0.0;         ///< the largest
    std::uint64_t differing = 0;       ///< patches with an error beyond its bound, or a vertex the kernels lack
    std::optional<std::string> first;  ///< a sentence about the first patch that differs

    bool equal() const { return differing == 0; }
};

/// Evaluates every patch on both, in the space of the kernels, and matches vertices by their domain point. `factors`
/// and memory budget of the options are used as for any job. `progress` (may be empty) is called with the fraction
/// done. Throws Error(usage) as compare_domain() does, for quads, and for factors that are neither one set nor one per
/// patch.
SurfaceComparison compare_surface(FixedFunctionTessellator& stage, const gpu::Device& device,
                                  const patches::PatchSet& patches, const TessellationOptions& options,
                                  const std::function<void(double)>& progress = {});

/// The domain point of captured coordinates; nothing where they are not exactly one.
std::optional<DomainPoint> domain_point(const Triple& coordinates, Domain domain);

/// True where the stage culled a patch whose outer factor is a positive denormal: Vulkan leaves it to the device
/// whether such a factor is flushed to zero on its way.
bool culled_by_flushing(const CapturedPatch& captured, Domain domain, const PatchFactors& factors);

}  // namespace tessera::verify
