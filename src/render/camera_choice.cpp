#include "render/camera_choice.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace tessera::render {
namespace {

/// The direction of a vector of any size; zero where it has none.
glm::dvec3 direction(const glm::dvec3& v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0.0) || !std::isfinite(largest)) return glm::dvec3(0.0);
    return glm::normalize(v / largest);
}

std::string text_of(const glm::dvec3& v) {
    return fmt::format("{:g},{:g},{:g}", v.x, v.y, v.z);
}

double times_power(double value, int exponent) {
    return std::ldexp(value, exponent);
}

glm::dvec3 times_power(const glm::dvec3& v, int exponent) {
    return {times_power(v.x, exponent), times_power(v.y, exponent), times_power(v.z, exponent)};
}

}  // namespace

Viewpoint viewpoint_of(const scene::Camera& camera) {
    Viewpoint viewpoint;
    viewpoint.eye = camera.eye;
    viewpoint.axes = camera.axes;
    viewpoint.projection = camera.orthographic ? Projection::orthographic : Projection::perspective;
    viewpoint.half_height = camera.half_height;
    viewpoint.half_width = camera.half_width;
    viewpoint.near_plane = camera.near_plane;
    viewpoint.far_plane = camera.far_plane;
    return viewpoint;
}

Viewpoint viewpoint_of(const LookAt& look, const glm::dvec3& middle) {
    const glm::dvec3 target = look.target.value_or(middle);
    const glm::dvec3 back = direction(look.eye - target);
    if (back == glm::dvec3(0.0)) {
        throw Error(ErrorKind::usage,
                    fmt::format("The camera's eye {} has no direction to its target {}; give two places "
                                "that differ.",
                                text_of(look.eye), text_of(target)));
    }
    glm::dvec3 across = glm::cross(direction(look.up.value_or(glm::dvec3(0.0, 1.0, 0.0))), back);
    if (!look.up && !(glm::length(across) > 1e-6)) across = glm::cross(glm::dvec3(0.0, 0.0, -1.0), back);
    if (!(glm::length(across) > 1e-9)) {
        throw Error(ErrorKind::usage,
                    fmt::format("The camera's up {} is no direction across the one in which it looks, from {} to {}.",
                                text_of(look.up.value_or(glm::dvec3(0.0))), text_of(look.eye), text_of(target)));
    }
    Viewpoint viewpoint;
    viewpoint.eye = look.eye;
    viewpoint.axes[0] = glm::normalize(across);
    viewpoint.axes[1] = glm::cross(back, viewpoint.axes[0]);
    viewpoint.axes[2] = back;
    viewpoint.projection = look.projection;
    viewpoint.half_height = look.half_height;
    return viewpoint;
}

CameraChoice scaled(CameraChoice choice, int exponent) {
    if (auto* const look = std::get_if<LookAt>(&choice)) {
        look->eye = times_power(look->eye, -exponent);
        if (look->target) look->target = times_power(*look->target, -exponent);
        if (look->projection == Projection::orthographic) {
            look->half_height = times_power(look->half_height, -exponent);
        }
    }
    if (auto* const viewpoint = std::get_if<Viewpoint>(&choice)) {
        viewpoint->eye = times_power(viewpoint->eye, -exponent);
        viewpoint->near_plane = times_power(viewpoint->near_plane, -exponent);
        viewpoint->far_plane = times_power(viewpoint->far_plane, -exponent);
        if (viewpoint->projection == Projection::orthographic) {
            viewpoint->half_height = times_power(viewpoint->half_height, -exponent);
            viewpoint->half_width = times_power(viewpoint->half_width, -exponent);
        }
    }
    return choice;
}

}  // namespace tessera::render
