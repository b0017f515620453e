// What the kernels of a scheme cost.
#pragma once

#include "measure/float_operations.hpp"
#include "tessellate/options.hpp"

#include <cstdint>

namespace tessera::findings {

struct KernelCosts {
    measure::FloatOperations net;       ///< per patch
    measure::FloatOperations vertex;    ///< per vertex: everything
    measure::FloatOperations position;  ///< of those, the position with its weights
    measure::FloatOperations rest;      ///< of those, barycentric weights and texture coordinates
    std::uint64_t net_bytes = 0;        ///< one control net

    /// Of those, the normal.
    measure::FloatOperations normal() const { return vertex - position - rest; }
};

/// Counted in the SPIR-V of the kernels for triangles.
KernelCosts triangle_costs(Scheme scheme, Normals normals);

/// Likewise for quads; `position` and `rest` are left zero.
KernelCosts quad_costs(Scheme scheme, Normals normals);

}  // namespace tessera::findings
