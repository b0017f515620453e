#include "views/patch_domain.hpp"

#include "tessellator/factors.h"
#include "tessellator/quad.h"
#include "tessellator/triangle.h"

#include <algorithm>
#include <bit>

namespace tessera::views {
namespace {

kernels::QuadPatch load_quad(const std::uint32_t* r) {
    return kernels::make_quad_patch(r[0], r[1], r[2], r[3], r[4], r[5], r[6]);
}

kernels::TrianglePatch load_triangle(const std::uint32_t* r) {
    return kernels::make_triangle_patch(r[0], r[1], r[2], r[3], r[4]);
}

}  // namespace

PatchDomain::PatchDomain(Domain domain, Partitioning partitioning, const PatchFactors& factors) : domain_(domain) {
    std::uint32_t raw[6];
    for (std::size_t i = 0; i < 6; ++i)
        raw[i] = std::bit_cast<std::uint32_t>(factors[i]);
    const kernels::PatchRecord record = kernels::make_patch_record(raw, static_cast<std::uint32_t>(partitioning),
                                                                   static_cast<std::uint32_t>(domain), 0);
    record_[0] = record.flags;
    std::copy(record.factor, record.factor + 6, record_ + 1);
    record_[7] = 0;
    if (domain == Domain::quad) {
        const kernels::QuadPatch patch = load_quad(record_);
        vertices_ = kernels::quad_point_count(patch);
        indices_ = 3 * kernels::quad_triangle_count(patch);
    } else {
        const kernels::TrianglePatch patch = load_triangle(record_);
        vertices_ = kernels::triangle_point_count(patch);
        indices_ = 3 * kernels::triangle_triangle_count(patch);
    }
    const std::size_t used = domain == Domain::quad ? 6 : 4;
    for (std::size_t i = 0; i < used; ++i) {
        const bool level = (record.flags & RECORD_UNIFORM) != 0;
        factors_[i] = level ? static_cast<float>(record.factor[0]) : static_cast<float>(record.factor[i]) * 0x1p-16f;
    }
}

std::vector<DomainPoint> PatchDomain::points() const {
    std::vector<DomainPoint> points(vertices_);
    if (domain_ == Domain::quad) {
        const kernels::QuadPatch patch = load_quad(record_);
        for (std::uint32_t i = 0; i < vertices_; ++i) {
            const kernels::DomainPoint point = kernels::quad_point(patch, i);
            points[i] = {point.u, point.v};
        }
    } else {
        const kernels::TrianglePatch patch = load_triangle(record_);
        for (std::uint32_t i = 0; i < vertices_; ++i) {
            const kernels::DomainPoint point = kernels::triangle_point(patch, i);
            points[i] = {point.u, point.v};
        }
    }
    return points;
}

}  // namespace tessera::views
