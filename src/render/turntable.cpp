#include "render/turntable.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tessera::render {
namespace {

constexpr int rings_each_way = 256;    // above and below the centre; what is beyond joins the outermost
constexpr double rings_per_size = 64;  // so that a model may be four times as high as it is said to be
constexpr int angles = 64;

}  // namespace

TurntableFraming::TurntableFraming(const View& view, float aspect, const glm::dvec3& centre, double size)
    : view_(view), aspect_(aspect), centre_(centre), step_(size / rings_per_size), rings_(2 * rings_each_way + 1) {
    if (!(step_ > 0.0) || !std::isfinite(step_)) step_ = 1.0;
}

void TurntableFraming::add(const glm::vec3& point) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) return;
    const glm::dvec3 place = glm::dvec3(point) - centre_;
    const double number = std::clamp(std::floor(place.y / step_), -double{rings_each_way}, double{rings_each_way});
    Ring& ring = rings_[static_cast<std::size_t>(number + double{rings_each_way})];
    const double radius = std::hypot(place.x, place.z);
    ring.low = ring.radius < 0.0 ? place.y : std::min(ring.low, place.y);
    ring.high = ring.radius < 0.0 ? place.y : std::max(ring.high, place.y);
    ring.radius = std::max(ring.radius, radius);
}

Viewpoint TurntableFraming::viewpoint() const {
    Framing framing(view_, aspect_);
    for (const Ring& ring : rings_) {
        if (ring.radius < 0.0) continue;
        for (int i = 0; i < angles; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / angles + double{view_.azimuth};
            // Corners of a polygon around the circle.
            const double radius = ring.radius / std::cos(std::numbers::pi / angles);
            for (const double height : {ring.low, ring.high}) {
                framing.add(
                    glm::vec3(centre_ + glm::dvec3(radius * std::sin(angle), height, radius * std::cos(angle))));
            }
        }
    }
    return framing.viewpoint();
}

}  // namespace tessera::render
