#include "render/camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tessera::render {

namespace {

/// A box in double precision, so that neither squares of 1e30 nor of 1e-30 leave the range.
struct Box {
    glm::dvec3 centre{0.0};
    glm::dvec3 half{0.5};
};

Box sane_box(const Bounds& bounds) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!std::isfinite(bounds.min[axis]) || !std::isfinite(bounds.max[axis]) ||
            bounds.min[axis] > bounds.max[axis]) {
            return {};
        }
    }
    const glm::dvec3 low(bounds.min);
    const glm::dvec3 high(bounds.max);
    Box box{(low + high) * 0.5, (high - low) * 0.5};
    // A point has no size to fit. It gets one that single precision still resolves at its place.
    const double reach = std::max({std::abs(box.centre.x), std::abs(box.centre.y), std::abs(box.centre.z)});
    const double smallest = reach * 1e-6;
    if (std::max({box.half.x, box.half.y, box.half.z}) <= smallest) {
        box.half = glm::dvec3(reach > 0.0 ? smallest : 0.5);
    }
    return box;
}

/// The power of two that brings `size` into [1, 2), within what single precision holds with room on both sides.
double scale_to_one(double size) {
    return std::ldexp(1.0, std::clamp(-std::ilogb(size), -100, 100));
}

float finite_or(float value, float otherwise) {
    return std::isfinite(value) ? value : otherwise;
}

bool is_finite(const glm::vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

glm::dvec3 corner(const Box& box, int number) {
    const glm::dvec3 side((number & 1) != 0 ? 1 : -1, (number & 2) != 0 ? 1 : -1, (number & 4) != 0 ? 1 : -1);
    return box.centre + side * box.half;
}

/// A tangent or a ratio that single precision and its products hold.
double sane_ratio(double value, double otherwise) {
    return std::isfinite(value) && value > 0.0 ? std::clamp(value, 1e-4, 1e4) : otherwise;
}

/// The place with numbers of at most `limit`.
glm::dvec3 finite_place(const glm::dvec3& place, double limit) {
    glm::dvec3 result(0.0);
    for (int axis = 0; axis < 3; ++axis)
        result[axis] = std::isnan(place[axis]) ? 0.0 : std::clamp(place[axis], -limit, limit);
    return result;
}

}  // namespace

Camera make_camera(const Viewpoint& viewpoint, const Bounds& bounds, float aspect) {
    const Box box = sane_box(bounds);
    const double diagonal = 2.0 * glm::length(box.half);
    const bool flat = viewpoint.projection == Projection::orthographic;
    const double scale = scale_to_one(std::max({box.half.x, box.half.y, box.half.z}));

    // Depth of the box's corners is within half a diagonal of the centre; another diagonal is room to swell.
    const glm::dvec3 eye = finite_place(viewpoint.eye, 1e45);
    const double away = std::clamp(glm::dot(eye - box.centre, viewpoint.axes[2]), -1e30 / scale, 1e30 / scale);
    double far_plane = std::max((away + 1.5 * diagonal) * scale, 2e-6);
    const double nearest = (away - 1.5 * diagonal) * scale;
    double near_plane = flat ? std::clamp(nearest, 0.0, far_plane / 2.0) : std::max(nearest, far_plane * 1e-3);
    // The viewpoint's own planes, where they cut off more. Far stays beyond near.
    if (viewpoint.near_plane * scale > near_plane) near_plane = std::min(viewpoint.near_plane * scale, 1e15);
    far_plane = std::max(std::min(far_plane, viewpoint.far_plane * scale), near_plane * 1.001 + 1e-6);

    // In camera space a flat image has a size; one in perspective has slopes.
    const double ratio = sane_ratio(aspect, 1.0);
    const double unit = flat ? scale : 1.0;
    const auto sane_half = [&](double half) {
        if (!flat) return sane_ratio(half, 0.3);
        return std::isnan(half) ? 1.0 : std::clamp(half, 1e-15, 1e15);
    };
    const double half_height = sane_half(std::max(viewpoint.half_height, viewpoint.half_width / ratio) * unit);
    const double half_width = half_height * ratio;

    Camera camera;
    camera.eye = glm::vec3(finite_place(eye, 3.4e38));
    // The eye along the camera's axes. From beyond what single precision holds nothing would be seen anyhow.
    const glm::dvec3 place = glm::clamp(glm::transpose(viewpoint.axes) * eye * scale, -1e30, 1e30);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            camera.view[column][row] = static_cast<float>(viewpoint.axes[row][column] * scale);
        camera.view[3][row] = static_cast<float>(-place[row]);
    }
    camera.projection = glm::mat4(0.0f);
    camera.projection[0][0] = static_cast<float>(1.0 / half_width);
    camera.projection[1][1] = static_cast<float>(-1.0 / half_height);
    if (flat) {
        const double depth = 1.0 / (near_plane - far_plane);
        camera.projection[2][2] = static_cast<float>(depth);
        camera.projection[3][2] = static_cast<float>(near_plane * depth);
        camera.projection[3][3] = 1.0f;
    } else {
        const double depth = far_plane / (near_plane - far_plane);
        camera.projection[2][2] = static_cast<float>(depth);
        camera.projection[2][3] = -1.0f;
        camera.projection[3][2] = static_cast<float>(near_plane * depth);
    }
    return camera;
}

Viewpoint turned(const Viewpoint& viewpoint, const glm::dvec3& centre, double angle) {
    if (angle == 0.0) return viewpoint;
    const double c = std::cos(angle), s = std::sin(angle);
    const glm::dmat3 turn(c, 0.0, -s, 0.0, 1.0, 0.0, s, 0.0, c);  // +z goes to +x
    Viewpoint result = viewpoint;
    result.eye = centre + turn * (viewpoint.eye - centre);
    result.axes = turn * viewpoint.axes;
    return result;
}

Framing::Framing(const View& view, float aspect) : projection_(view.projection), aspect_(aspect) {
    const View defaults;
    const double azimuth = finite_or(view.azimuth, defaults.azimuth);
    const double elevation = finite_or(view.elevation, defaults.elevation);
    // The axes come from the angles alone, so that no direction is special.
    axes_[0] = {std::cos(azimuth), 0.0, -std::sin(azimuth)};
    axes_[2] = {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation)};
    axes_[1] = glm::cross(axes_[2], axes_[0]);

    const double angle = std::clamp(finite_or(view.field_of_view, defaults.field_of_view), 0.01f, 3.0f);
    const glm::dvec2 shape(sane_ratio(aspect, 1.0), 1.0);
    slopes_ = (projection_ == Projection::perspective ? std::tan(angle / 2.0) : 0.0) * shape;
    distance_ = std::max(finite_or(view.distance, defaults.distance), 0.01f);
}

// A point c is inside the right edge of the image when
//     c.right - e.right <= slope * (e.back - c.back)   for the eye e, that is
//     c.right + slope * c.back <= e.right + slope * e.back
// and likewise at the other three edges. Each edge keeps one number, the largest left side; those of two opposite edges
// give the eye's place and its distance. Without perspective the slope is 0, and they give the image's size.
void Framing::add(const glm::vec3& point) {
    if (!is_finite(point)) return;
    bounds_.min = glm::min(bounds_.min, point);
    bounds_.max = glm::max(bounds_.max, point);
    const glm::dvec3 c = glm::transpose(axes_) * glm::dvec3(point);
    const glm::dvec2 across(c);
    const glm::dvec2 reach = slopes_ * (double{fill} * c.z);
    positive_ = glm::max(positive_, reach + across);
    negative_ = glm::max(negative_, reach - across);
    nearest_ = std::max(nearest_, c.z);
}

Viewpoint Framing::viewpoint() const {
    const Box box = sane_box(bounds_);
    Framing fit = *this;
    if (bounds_.min.x > bounds_.max.x || bounds_.min == bounds_.max) {
        for (int number = 0; number < 8; ++number)
            fit.add(glm::vec3(corner(box, number)));
    }
    const double diagonal = 2.0 * glm::length(box.half);
    const double middle = glm::dot(box.centre, axes_[2]);
    const glm::dvec2 sideways = (fit.positive_ - fit.negative_) * 0.5;
    const glm::dvec2 reach = (fit.positive_ + fit.negative_) / (2.0 * double{fill});

    Viewpoint result;
    result.axes = axes_;
    result.projection = projection_;
    double away = 2.0 * diagonal;
    if (projection_ == Projection::perspective) {
        // A line seen end on fits from any distance: keep clear of it.
        away =
            (std::max({reach.x / slopes_.x, reach.y / slopes_.y, fit.nearest_ + 0.01 * diagonal}) - middle) * distance_;
        result.half_height = slopes_.y;
    } else {
        result.half_height = std::max({reach.x / sane_ratio(aspect_, 1.0), reach.y, 0.001 * diagonal}) * distance_;
    }
    result.eye = axes_ * glm::dvec3(sideways, middle + away);
    return result;
}

Camera frame_bounds(const Bounds& bounds, const View& view, float aspect) {
    Framing framing(view, aspect);
    const Box box = sane_box(bounds);
    for (int number = 0; number < 8; ++number)
        framing.add(glm::vec3(corner(box, number)));
    return framing.camera();
}

}  // namespace tessera::render
