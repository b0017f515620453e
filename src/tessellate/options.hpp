// What a tessellation job may be asked for.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tessera {

/// The shape of a patch's domain. The values are those of the kernels (kernels/layout.h).
enum class Domain : std::uint32_t { triangle = 0, quad = 1, isoline = 2 };

/// How a patch is curved.
enum class Scheme {
    linear,  ///< flat
    phong,   ///< Phong tessellation, Boubekeur and Alexa 2008: quadratic
    pn,      ///< PN triangles, Vlachos et al. 2001: cubic
    stpn,    ///< scalar tagged PN triangles, after Boubekeur, Reuter, Schlick 2005: cubic, with creases
};

/// How normals vary over a patch.
enum class Normals {
    linear,     ///< interpolated from the corners
    quadratic,  ///< with a coefficient per edge, Vlachos et al. 2001, section 3.3
    surface,    ///< "true": the surface's own, across its derivatives; neighbours differ where it has a crease
};

/// What tangent frames come with the vertices. See Tangent (base/tangent.hpp) and kernels/schemes/tangent_frame.h.
enum class Tangents {
    none,
    surface,  ///< along the surface's derivatives, Dupuy, equations 4 and 5
    uv,       ///< along its texture coordinates: what normal maps need; where those do not vary, as `surface`
};

/// How a factor becomes segments. The values are those of the kernels (kernels/layout.h).
enum class Partitioning : std::uint32_t {
    integer = 0,
    pow2 = 1,
    fractional_odd = 2,
    fractional_even = 3,
    uniform = 4,  ///< the even grid of Vlachos et al. 2001; one level per patch, the largest of its factors
};

/// Factors in the order of the specification, padded to six: triangles edge U=0, V=0, W=0, inside; quads edge U=0, V=0,
/// U=1, V=1, inside U, inside V; isolines density (lines), detail (segments).
using PatchFactors = std::array<float, 6>;

/// What faces a tessellator hands on.
enum class Topology {
    triangles,
    quads,  ///< where a quad patch's pattern is a regular grid, its cells are marked as quads
};

struct TessellationOptions {
    Scheme scheme = Scheme::pn;
    Normals normals = Normals::quadratic;
    Tangents tangents = Tangents::none;
    Partitioning partitioning = Partitioning::fractional_odd;
    /// One set for every patch, or one per patch. Any float is allowed: factors are clamped to [1, 64] and a patch with
    /// an outer factor that is not positive is culled, as the fixed-function stage does.
    std::variant<PatchFactors, std::vector<PatchFactors>> factors = PatchFactors{4, 4, 4, 4, 4, 4};
    /// Shape factor of Phong tessellation in [0, 1]: 0 flat, 1 full; for control vertices that have none of their own.
    float alpha = 0.75f;
    Topology topology = Topology::triangles;
    /// Bytes of device memory a job may take; outputs larger than that are made in batches.
    std::uint64_t memory_budget = 512ull << 20;
    /// Measure each stage on the device (Job::times). Costs a wait after every submission.
    bool time_stages = false;
};

/// The degree of a scheme's patches, 1 to 3.
std::uint32_t degree(Scheme scheme);

/// Names as the command line has them ("pn", "fractional_odd", ...). The parsing functions throw Error(usage) with
/// the list of names.
std::string_view name(Domain domain);
std::string_view name(Scheme scheme);
std::string_view name(Normals normals);
std::string_view name(Tangents tangents);
std::string_view name(Partitioning partitioning);
std::string_view name(Topology topology);
Domain domain_from_name(std::string_view name);
Scheme scheme_from_name(std::string_view name);
Normals normals_from_name(std::string_view name);
Tangents tangents_from_name(std::string_view name);
Partitioning partitioning_from_name(std::string_view name);
Topology topology_from_name(std::string_view name);

}  // namespace tessera
