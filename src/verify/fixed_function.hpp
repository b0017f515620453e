// A device's own tessellation stage, which judges the kernels: what it makes of factors, and of surfaces written for it
// independently. Implemented by backends that have such a stage (Vulkan).
#pragma once

#include "gpu/types.hpp"
#include "tessellate/options.hpp"
#include "tessellate/refined_mesh.hpp"

#include <array>
#include <span>
#include <vector>

namespace tessera::verify {

using Triple = std::array<float, 3>;

/// What the evaluation shader computed at a vertex.
struct CapturedPoint {
    Triple position;
    Triple normal;  ///< as blended, before it is made unit
};

/// What the stage made of one patch: three vertices per triangle, two per line segment, in the stage's order; none for
/// a culled patch.
struct CapturedPatch {
    std::vector<Triple> coordinates;    ///< where in the domain (gl_TessCoord)
    std::vector<CapturedPoint> points;  ///< what lies there; empty where only the domain was asked for
};

/// A surface over triangles.
struct CapturedSurface {
    Scheme scheme = Scheme::pn;
    Normals normals = Normals::quadratic;
    float alpha = 0.75f;  ///< shape factor of Phong tessellation
};

class FixedFunctionTessellator {
public:
    virtual ~FixedFunctionTessellator() = default;
    virtual const gpu::DeviceInfo& info() const = 0;

    /// Tessellates one patch per set of factors. `clockwise` is the D3D word (see make_patterns). Throws Error(usage)
    /// for a partitioning that the stage does not have, Error(device_unavailable) when the device fails.
    virtual std::vector<CapturedPatch> tessellate(Domain domain, Partitioning partitioning, bool clockwise,
                                                  std::span<const PatchFactors> factors) = 0;

    /// Same over triangles (clockwise), and evaluates the surface over `corners`, three per set of factors.
    virtual std::vector<CapturedPatch> evaluate(const CapturedSurface& surface, Partitioning partitioning,
                                                std::span<const PatchFactors> factors,
                                                std::span<const Vertex> corners) = 0;
};

}  // namespace tessera::verify
