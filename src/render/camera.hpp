// Camera, and framing that shows a whole model.
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace tessera::render {

/// A right-handed perspective camera. `view` leads to camera space: x right, y up, z towards the viewer, eye at the
/// origin. It holds a rotation and a uniform scale that is a power of two: with models of any size, camera space has
/// sizes near 1, so that single precision (and hardware that flushes denormals) draws them all alike. `projection`
/// leads on to Vulkan's clip space: y down, depth 0 at the near plane and 1 at the far plane.
struct Camera {
    glm::vec3 eye{0.0f};  ///< in the model's units
    glm::mat4 view{1.0f};
    glm::mat4 projection{1.0f};
};

/// An axis-aligned box; empty when min > max.
struct Bounds {
    glm::vec3 min{3.4e38f};
    glm::vec3 max{-3.4e38f};
};

/// Where to look from: angles in radians around the model, +y up. Defaults are a three-quarter view from the front
/// right and a little above.
struct View {
    float azimuth = 0.6f;        ///< from +z towards +x
    float elevation = 0.35f;     ///< above the horizon; any angle, straight up and down included
    float field_of_view = 0.6f;  ///< vertical; kept in [0.01, 3]
    float distance = 1.0f;       ///< times the distance that just fits the model; at least 0.01
};

/// The part of the image's width or height that frame_bounds() lets a model fill.
inline constexpr float fill = 0.92f;

/// Frames points one by one, so that nothing need be held: the camera it gives is the nearest from which all of them
/// fit an image. At `view.distance` 1 they fill the share `fill` of its width or of its height, centred, and the other
/// side has room to spare. The near and far planes leave room for surfaces that swell out of the points' box by its own
/// diagonal. Where there is no point, the unit box around the origin is framed; all points in one place are fine.
class Framing {
public:
    /// `aspect` is width / height; values that make no sense are replaced by sensible ones.
    Framing(const View& view, float aspect);

    /// Points that are not finite are left out.
    void add(const glm::vec3& point);

    Camera camera() const;

private:
    glm::dvec3 right_, up_, back_;  // of the camera, in the model's axes
    glm::dvec2 slopes_;             // of the image's right and upper edges
    double distance_;
    glm::dvec2 positive_{-1e300}, negative_{-1e300};
    double nearest_ = -1e300;
    Bounds bounds_;
};

/// Frames the eight corners of a box. One that is empty or not finite counts as the unit box around the origin.
Camera frame_bounds(const Bounds& bounds, const View& view, float aspect);

}  // namespace tessera::render
