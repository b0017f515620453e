#include "render/survey.hpp"

#include <algorithm>

namespace tessera::render {
namespace {

View view_of(const CameraChoice& choice) {
    const View* const view = std::get_if<View>(&choice);
    return view == nullptr ? View{} : *view;
}

glm::dvec3 middle_of(const Bounds& bounds) {
    return (glm::dvec3(bounds.min) + glm::dvec3(bounds.max)) * 0.5;
}

double size_of(const Bounds& bounds) {
    const glm::dvec3 half = (glm::dvec3(bounds.max) - glm::dvec3(bounds.min)) * 0.5;
    return std::max({half.x, half.y, half.z});
}

}  // namespace

Survey::Survey(const CameraChoice& choice, float aspect, bool turning, const Bounds& coarse)
    : choice_(choice),
      aspect_(aspect),
      turning_(turning && std::holds_alternative<View>(choice)),
      about_(middle_of(coarse)),
      framing_(view_of(choice), aspect),
      turntable_(view_of(choice), aspect, about_, size_of(coarse)) {}

void Survey::append(const MeshBatch& batch) {
    for (const Vertex& vertex : batch.vertices) {
        const glm::vec3 point(vertex.position[0], vertex.position[1], vertex.position[2]);
        framing_.add(point);
        if (turning_) turntable_.add(point);
    }
}

Camera Survey::camera(double angle) const {
    const Bounds& bounds = framing_.bounds();
    const glm::dvec3 middle = middle_of(bounds);
    if (const auto* const look = std::get_if<LookAt>(&choice_)) {
        return make_camera(turned(viewpoint_of(*look, middle), look->target.value_or(middle), angle), bounds, aspect_);
    }
    if (const auto* const viewpoint = std::get_if<Viewpoint>(&choice_)) {
        return make_camera(turned(*viewpoint, middle, angle), bounds, aspect_);
    }
    const Viewpoint viewpoint = turning_ ? turntable_.viewpoint() : framing_.viewpoint();
    return make_camera(turned(viewpoint, about_, angle), bounds, aspect_);
}

Bounds bounds_of(std::span<const Vertex> vertices) {
    Bounds bounds;
    for (const Vertex& vertex : vertices) {
        const glm::vec3 point(vertex.position[0], vertex.position[1], vertex.position[2]);
        bounds.min = glm::min(bounds.min, point);
        bounds.max = glm::max(bounds.max, point);
    }
    return bounds;
}

glm::vec2 depth_range(const Camera& camera, const Bounds& box) {
    glm::vec2 range(3.4e38f, -3.4e38f);
    for (int corner = 0; corner < 8; ++corner) {
        glm::vec3 point;
        for (int axis = 0; axis < 3; ++axis)
            point[axis] = (corner >> axis & 1) != 0 ? box.max[axis] : box.min[axis];
        const float ahead = -(camera.view * glm::vec4(point, 1.0f)).z;
        range = {std::min(range.x, ahead), std::max(range.y, ahead)};
    }
    return {std::max(range.x, 0.0f), range.y};
}

}  // namespace tessera::render
