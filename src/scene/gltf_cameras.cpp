#include "scene/gltf_cameras.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace tessera::scene {
namespace {

/// Why a camera cannot be used, or nothing.
std::optional<std::string> find_fault(const CameraSource& source) {
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    const double near_plane = source.near_plane.value_or(0.0);
    if (source.orthographic) {
        if (!positive(source.half_width.value_or(0.0))) return "its xmag is missing or not above 0";
        if (!positive(source.half_height.value_or(0.0))) return "its ymag is missing or not above 0";
        if (!source.near_plane || !(near_plane >= 0.0)) return "its znear is missing or below 0";
        if (!source.far_plane) return "its zfar is missing";
    } else {
        const double angle = source.field_of_view.value_or(0.0);
        if (!positive(angle) || angle >= std::numbers::pi) return "its yfov is missing or not between 0 and pi";
        if (source.aspect && !positive(*source.aspect)) return "its aspectRatio is not above 0";
        if (!positive(near_plane)) return "its znear is missing or not above 0";
    }
    if (source.far_plane && !(*source.far_plane > near_plane)) return "its zfar is not above its znear";
    return std::nullopt;
}

/// The rotation of a node, its scale taken out; nothing where none is left. Axes are made long enough for squares
/// first.
std::optional<glm::dmat3> directions(const glm::dmat4& world) {
    const auto unit = [](const glm::dvec3& v) {
        const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        return largest > 0.0 && std::isfinite(largest) ? glm::normalize(v / largest) : glm::dvec3(0.0);
    };
    const glm::dvec3 back = unit(glm::dvec3(world[2]));
    const glm::dvec3 right = unit(glm::cross(unit(glm::dvec3(world[1])), back));
    if (back == glm::dvec3(0.0) || right == glm::dvec3(0.0)) return std::nullopt;
    return glm::dmat3(right, glm::cross(back, right), back);
}

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

void load_cameras(const Document& document, const NodeGraph& graph, Scene& scene) {
    std::set<std::size_t> shown;
    for (const int node : graph.cameras) {
        const auto& of = document.model.nodes[static_cast<std::size_t>(node)];
        const auto index = static_cast<std::size_t>(of.camera);
        shown.insert(index);
        const CameraSource& source = document.cameras[index];
        const auto leave_out = [&](const std::string& reason) {
            document.diagnostics.note(fmt::format("cameras[{}] is left out: {}.", index, reason));
        };
        if (const auto fault = find_fault(source)) {
            leave_out(*fault);
            continue;
        }
        const glm::dmat4& world = graph.world[static_cast<std::size_t>(node)];
        const auto axes = directions(world);
        if (!axes || !is_finite(glm::dvec3(world[3]))) {
            leave_out(fmt::format("the transform of nodes[{}] gives it no place or no direction", node));
            continue;
        }
        Camera camera;
        camera.name = !of.name.empty() ? of.name : source.name;
        camera.eye = glm::dvec3(world[3]);
        camera.axes = *axes;
        camera.orthographic = source.orthographic;
        camera.half_height =
            source.orthographic ? *source.half_height : std::tan(source.field_of_view.value_or(0.0) / 2.0);
        camera.half_width = source.orthographic ? *source.half_width : camera.half_height * source.aspect.value_or(0.0);
        if (!std::isfinite(camera.half_width)) {
            leave_out("its aspectRatio is too large");
            continue;
        }
        camera.near_plane = source.near_plane.value_or(0.0);
        camera.far_plane = source.far_plane.value_or(std::numeric_limits<double>::infinity());
        scene.cameras.push_back(std::move(camera));
    }
    for (std::size_t i = 0; i < document.cameras.size(); ++i) {
        if (!shown.contains(i)) {
            document.diagnostics.note(fmt::format("cameras[{}] is left out: no node of the scene carries it.", i));
        }
    }
}

}  // namespace tessera::scene
