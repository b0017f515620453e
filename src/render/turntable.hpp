// Framing of a model that turns.
#pragma once

#include "render/camera.hpp"

#include <vector>

namespace tessera::render {

/// Frames what points sweep while they turn about a vertical axis, so that size and place stay the same at every angle.
/// Of the points only the profile is kept: how far they are from the axis at each of many heights, a little more than
/// exactly.
class TurntableFraming {
public:
    /// The axis goes through `centre`; `size` is about that of the model, such as half its largest extent.
    TurntableFraming(const View& view, float aspect, const glm::dvec3& centre, double size);

    /// Points that are not finite are left out.
    void add(const glm::vec3& point);

    /// Where the camera stands at angle 0.
    Viewpoint viewpoint() const;

private:
    struct Ring {
        double radius = -1.0;  // below 0 where no point is
        double low = 0.0, high = 0.0;
    };

    View view_;
    float aspect_;
    glm::dvec3 centre_;
    double step_;
    std::vector<Ring> rings_;
};

}  // namespace tessera::render
