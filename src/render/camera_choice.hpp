// The ways to say where a picture is seen from.
#pragma once

#include "render/camera.hpp"
#include "scene/scene.hpp"

#include <optional>
#include <variant>

namespace tessera::render {

/// A camera as people give it, in the model's units.
struct LookAt {
    glm::dvec3 eye{0.0};
    std::optional<glm::dvec3> target;  ///< else the middle of the model
    std::optional<glm::dvec3> up;      ///< else +y, or where that is where it looks, -z
    Projection projection = Projection::perspective;
    double half_height = 0.3;  ///< as in Viewpoint
};

/// An orbit that frames the model, a camera placed by hand, or one that is given whole.
using CameraChoice = std::variant<View, LookAt, Viewpoint>;

/// A camera of a scene. At least what its own aspect shows is inside every image.
Viewpoint viewpoint_of(const scene::Camera& camera);

/// Where a LookAt stands, given the middle of the model. Throws Error(usage) where the eye is at the target or looks
/// along `up`, and for numbers that are not finite.
Viewpoint viewpoint_of(const LookAt& look, const glm::dvec3& middle);

/// The choice in units 2^-exponent times the model's, those of patches::PatchSet.
CameraChoice scaled(CameraChoice choice, int exponent);

}  // namespace tessera::render
