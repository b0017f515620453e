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

}  // namespace

Framing::Framing(const View& view, float aspect) {
    const View defaults;
    const double azimuth = finite_or(view.azimuth, defaults.azimuth);
    const double elevation = finite_or(view.elevation, defaults.elevation);
    // The axes come from the angles alone, so that no direction is special.
    right_ = {std::cos(azimuth), 0.0, -std::sin(azimuth)};
    back_ = {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation)};
    up_ = glm::cross(back_, right_);

    const double angle = std::clamp(finite_or(view.field_of_view, defaults.field_of_view), 0.01f, 3.0f);
    const double ratio = std::isfinite(aspect) && aspect > 0.0f ? std::clamp(aspect, 1e-4f, 1e4f) : 1.0;
    slopes_ = std::tan(angle / 2.0) * glm::dvec2(ratio, 1.0);
    distance_ = std::max(finite_or(view.distance, defaults.distance), 0.01f);
}

// A point c is inside the right edge of the image when
//     c.right - e.right <= slope * (e.back - c.back)   for the eye e, that is
//     c.right + slope * c.back <= e.right + slope * e.back
// and likewise at the other three edges. Each edge keeps one number, the largest left side; those of two opposite edges
// give the eye's place and its distance.
void Framing::add(const glm::vec3& point) {
    if (!is_finite(point)) return;
    bounds_.min = glm::min(bounds_.min, point);
    bounds_.max = glm::max(bounds_.max, point);
    const glm::dvec3 c(point);
    const double depth = glm::dot(c, back_);
    const glm::dvec2 across(glm::dot(c, right_), glm::dot(c, up_));
    const glm::dvec2 reach = slopes_ * (double{fill} * depth);
    positive_ = glm::max(positive_, reach + across);
    negative_ = glm::max(negative_, reach - across);
    nearest_ = std::max(nearest_, depth);
}

Camera Framing::camera() const {
    const Box box = sane_box(bounds_);
    Framing fit = *this;
    if (bounds_.min.x > bounds_.max.x || bounds_.min == bounds_.max) {
        for (int number = 0; number < 8; ++number)
            fit.add(glm::vec3(corner(box, number)));
    }
    const double diagonal = 2.0 * glm::length(box.half);
    const double middle = glm::dot(box.centre, back_);
    const glm::dvec2 sideways = (fit.positive_ - fit.negative_) * 0.5;
    const glm::dvec2 fits = (fit.positive_ + fit.negative_) / (2.0 * double{fill} * slopes_);
    // A line seen end on fits from any distance: keep clear of it.
    const double away = (std::max({fits.x, fits.y, fit.nearest_ + 0.01 * diagonal}) - middle) * distance_;

    // Depth of the box's corners is within half a diagonal of the centre; another diagonal is room to swell.
    const double scale = scale_to_one(std::max({box.half.x, box.half.y, box.half.z}));
    const double far_plane = std::max((away + 1.5 * diagonal) * scale, 2e-6);
    const double near_plane = std::max((away - 1.5 * diagonal) * scale, far_plane * 1e-3);

    Camera camera;
    const glm::dvec3 eye(sideways, middle + away);  // along the camera's axes
    camera.eye = glm::vec3(right_ * eye.x + up_ * eye.y + back_ * eye.z);
    const std::array rows{right_, up_, back_};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            camera.view[column][row] = static_cast<float>(rows[static_cast<std::size_t>(row)][column] * scale);
        }
        camera.view[3][row] = static_cast<float>(-eye[row] * scale);
    }
    const double depth = far_plane / (near_plane - far_plane);
    camera.projection = glm::mat4(0.0f);
    camera.projection[0][0] = static_cast<float>(1.0 / slopes_.x);
    camera.projection[1][1] = static_cast<float>(-1.0 / slopes_.y);
    camera.projection[2][2] = static_cast<float>(depth);
    camera.projection[2][3] = -1.0f;
    camera.projection[3][2] = static_cast<float>(near_plane * depth);
    return camera;
}

Camera frame_bounds(const Bounds& bounds, const View& view, float aspect) {
    Framing framing(view, aspect);
    const Box box = sane_box(bounds);
    for (int number = 0; number < 8; ++number)
        framing.add(glm::vec3(corner(box, number)));
    return framing.camera();
}

}  // namespace tessera::render
