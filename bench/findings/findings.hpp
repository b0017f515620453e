// The findings, each a chapter of the document.
#pragma once

#include "document.hpp"
#include "models.hpp"

#include "gpu/device.hpp"
#include "tessellate/options.hpp"

namespace tessera::findings {

struct Bench {
    gpu::Device device;  ///< reference
    std::vector<Model> models;
    std::filesystem::path pictures;  ///< where silhouettes are written, or empty
};

/// True against quadratic normals: angles, discontinuities, operations.
void write_normals_finding(const Bench& bench, Document& document);
/// Concentric patterns against the even grid: distances and silhouettes.
void write_pattern_finding(const Bench& bench, Document& document);
/// Phong, PN with linear and with quadratic normals: continuity, operations, bytes.
void write_scheme_finding(const Bench& bench, Document& document);
/// The triangle counts of patterns.
void write_triangle_counts(const Bench& bench, Document& document);

/// Six equal factors.
inline PatchFactors equal_factors(float f) {
    return {f, f, f, f, f, f};
}

}  // namespace tessera::findings
