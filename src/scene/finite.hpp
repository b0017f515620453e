// Whether a vector is made of numbers.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace tessera::scene {

/// True where no coordinate is infinite or not a number.
inline bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace tessera::scene
