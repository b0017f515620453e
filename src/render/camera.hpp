// Camera, and framing that shows a whole model.
#pragma once

#include <glm/glm.hpp>
#include <limits>
#include <span>

namespace tessera::render {

/// A right-handed camera, perspective or orthographic. `view` leads to camera space: x right, y up, z towards the
/// viewer, eye at the origin. It holds a rotation and a uniform scale that is a power of two: with models of any size,
/// camera space has sizes near 1, so that single precision (and hardware that flushes denormals) draws them all alike.
/// `projection` leads on to Vulkan's clip space: y down, depth 0 at the near plane and 1 at the far plane.
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

enum class Projection { perspective, orthographic };

/// Where to look from: angles in radians around the model, +y up. Defaults are a three-quarter view from the front
/// right and a little above.
struct View {
    float azimuth = 0.6f;        ///< from +z towards +x
    float elevation = 0.35f;     ///< above the horizon; any angle, straight up and down included
    float field_of_view = 0.6f;  ///< vertical; kept in [0.01, 3]; of no account without perspective
    float distance = 1.0f;       ///< times the distance (orthographic: size) that just fits the model; at least 0.01
    Projection projection = Projection::perspective;
};

/// A camera that does not know the image and the model yet. It looks along -axes[2].
struct Viewpoint {
    glm::dvec3 eye{0.0};
    glm::dmat3 axes{1.0};  ///< right, up and back: orthonormal
    Projection projection = Projection::perspective;
    /// Half the height of what it sees: orthographic in the model's units, perspective at distance 1 (the tangent of
    /// half the angle). Above 0.
    double half_height = 0.3;
    /// Likewise, at least this wide: a narrower image shows more above and below. 0 leaves the width to the image.
    double half_width = 0.0;
    double near_plane = 0.0;  ///< nothing nearer is drawn
    double far_plane = std::numeric_limits<double>::infinity();
};

/// The camera at a viewpoint for images of aspect width / height. The near and far planes are fitted to the model's box
/// with room for surfaces that swell out of it by its own diagonal, within the viewpoint's planes. Numbers that make no
/// sense are replaced by sensible ones: the camera is always finite.
Camera make_camera(const Viewpoint& viewpoint, const Bounds& bounds, float aspect);

/// The viewpoint moved around the vertical axis through `centre` by an angle in radians, from +z towards +x, looking at
/// what it looked at: what a turntable shows.
Viewpoint turned(const Viewpoint& viewpoint, const glm::dvec3& centre, double angle);

/// The part of the image's width or height that framing lets a model fill.
inline constexpr float fill = 0.92f;

/// Frames points one by one, so that nothing need be held: the camera it gives is the nearest from which all of them
/// fit an image. At `view.distance` 1 they fill the share `fill` of its width or of its height, centred, and the other
/// side has room to spare. Where there is no point, the unit box around the origin is framed; all points in one place
/// are fine.
class Framing {
public:
    /// `aspect` is width / height; values that make no sense are replaced by sensible ones.
    Framing(const View& view, float aspect);

    /// Points that are not finite are left out.
    void add(const glm::vec3& point);

    /// The box of the points so far.
    const Bounds& bounds() const { return bounds_; }
    Viewpoint viewpoint() const;
    Camera camera() const { return make_camera(viewpoint(), bounds_, aspect_); }

private:
    Projection projection_;
    float aspect_;
    glm::dmat3 axes_;    // of the camera, in the model's axes
    glm::dvec2 slopes_;  // of the image's right and upper edges
    double distance_;
    glm::dvec2 positive_{-1e300}, negative_{-1e300};
    double nearest_ = -1e300;
    Bounds bounds_;
};

/// Frames the eight corners of a box. One that is empty or not finite counts as the unit box around the origin.
Camera frame_bounds(const Bounds& bounds, const View& view, float aspect);

}  // namespace tessera::render
