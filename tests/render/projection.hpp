// Where cameras put points.
#pragma once

#include <glm/glm.hpp>

#include "render/camera.hpp"

namespace tessera::test {

/// x, y in [-1, 1] inside the image, y down; z the depth, in [0, 1] where it is drawn.
inline glm::vec3 project(const render::Camera& camera, const glm::vec3& point) {
    const glm::vec4 clip = camera.projection * (camera.view * glm::vec4(point, 1.0f));
    return glm::vec3(clip) / clip.w;
}

/// Whether every number of the camera is finite.
inline bool is_finite(const render::Camera& camera) {
    bool finite = true;
    for (int i = 0; i < 16; ++i) {
        finite = finite && glm::abs(camera.view[i / 4][i % 4]) < 3.3e38f;
        finite = finite && glm::abs(camera.projection[i / 4][i % 4]) < 3.3e38f;
    }
    return finite && glm::length(glm::dvec3(camera.eye)) < 1e39;
}

}  // namespace tessera::test
