// The schemes as their papers write them, in double precision and with none of the kernels' structure: what the kernels
// are held against.
#pragma once

#include "schemes/corners.h"

#include <array>
#include <glm/vec3.hpp>

namespace tessera::test {

/// Corner i belongs to coordinate i: u, v, w.
struct PaperPatch {
    std::array<glm::dvec3, 3> p;
    std::array<glm::dvec3, 3> n;
};

PaperPatch paper_patch(const kernels::Corners& corners);

glm::dvec3 paper_linear(const std::array<glm::dvec3, 3>& values, glm::dvec3 uvw);

/// Vlachos, Peters, Boyd, Mitchell 2001, section 3.2: the cubic Bezier triangle.
glm::dvec3 paper_pn_position(const PaperPatch& patch, glm::dvec3 uvw);

/// Boubekeur and Alexa 2008: (1 - alpha) p + alpha (u pi_0(p) + v pi_1(p) + w pi_2(p)).
glm::dvec3 paper_phong_position(const PaperPatch& patch, double alpha, glm::dvec3 uvw);

/// Vlachos et al. 2001, section 3.3: quadratically varying normals, before the final normalisation.
glm::dvec3 paper_quadratic_normal(const PaperPatch& patch, glm::dvec3 uvw);

}  // namespace tessera::test
