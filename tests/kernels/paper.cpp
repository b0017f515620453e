#include "kernels/paper.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace tessera::test {
namespace {

using glm::dvec3;

dvec3 widen(const kernels::Vector& v) {
    return {v.x, v.y, v.z};
}

}  // namespace

PaperPatch paper_patch(const kernels::Corners& c) {
    return {{widen(c.p0), widen(c.p1), widen(c.p2)}, {widen(c.n0), widen(c.n1), widen(c.n2)}};
}

dvec3 paper_linear(const std::array<dvec3, 3>& values, dvec3 uvw) {
    return values[0] * uvw[0] + values[1] * uvw[1] + values[2] * uvw[2];
}

dvec3 paper_pn_position(const PaperPatch& patch, dvec3 uvw) {
    // b_ij with two shares of corner i and one of corner j: (2 P_i + P_j - w_ij N_i) / 3, w_ij = (P_j - P_i) . N_i.
    const auto b = [&](int i, int j) {
        const double w = glm::dot(patch.p[j] - patch.p[i], patch.n[i]);
        return (2.0 * patch.p[i] + patch.p[j] - w * patch.n[i]) / 3.0;
    };
    dvec3 sum(0.0);
    dvec3 e(0.0);
    for (int i = 0; i < 3; ++i) {
        sum += patch.p[i] * std::pow(uvw[i], 3);
        for (int j = 0; j < 3; ++j) {
            if (i != j) {
                sum += b(i, j) * (3.0 * uvw[i] * uvw[i] * uvw[j]);
                e += b(i, j) / 6.0;
            }
        }
    }
    const dvec3 v = (patch.p[0] + patch.p[1] + patch.p[2]) / 3.0;
    return sum + (e + (e - v) / 2.0) * (6.0 * uvw[0] * uvw[1] * uvw[2]);
}

dvec3 paper_phong_position(const PaperPatch& patch, double alpha, dvec3 uvw) {
    const dvec3 p = paper_linear(patch.p, uvw);
    dvec3 curved(0.0);
    for (int i = 0; i < 3; ++i) {
        curved += uvw[i] * (p - glm::dot(p - patch.p[i], patch.n[i]) * patch.n[i]);
    }
    return (1.0 - alpha) * p + alpha * curved;
}

dvec3 paper_quadratic_normal(const PaperPatch& patch, dvec3 uvw) {
    dvec3 sum(0.0);
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const dvec3 d = patch.p[j] - patch.p[i];
        const dvec3 both = patch.n[i] + patch.n[j];
        const double v = glm::dot(d, d) == 0.0 ? 0.0 : 2.0 * glm::dot(d, both) / glm::dot(d, d);
        const dvec3 h = both - v * d;
        const double length = glm::length(h);
        sum += patch.n[i] * (uvw[i] * uvw[i]) + (length == 0.0 ? dvec3(0.0) : h / length) * (uvw[i] * uvw[j]);
    }
    return sum;
}

}  // namespace tessera::test
