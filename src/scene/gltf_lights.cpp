#include "scene/gltf_lights.hpp"

#include "scene/json_object.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tessera::scene {
namespace {

constexpr const char* extension = "KHR_lights_punctual";

/// A light as the text has it, in its node's space.
struct Source {
    Light light;
    std::string fault;  ///< why it cannot be used
};

Source read_light(JsonObject& object, const nlohmann::json& copy) {
    Source source;
    Light& light = source.light;
    const std::string type = object.string("type", Need::required).value();
    if (type == "point") {
        light.kind = Light::Kind::point;
    } else if (type == "spot") {
        light.kind = Light::Kind::spot;
    } else if (type != "directional") {
        object.refuse("type", "is " + in_quotes(type) + ", but must be directional, point or spot");
    }
    object.numbers("color", 3);
    glm::dvec3 colour(1.0);
    if (object.has("color")) {
        for (int i = 0; i < 3; ++i)
            colour[i] = copy["color"][static_cast<std::size_t>(i)].get<double>();
    }
    const double intensity = object.number("intensity").value_or(1.0);
    const double range = object.number("range").value_or(0.0);
    double inner = 0.0, outer = std::numbers::pi / 4.0;
    object.object("spot", [&](JsonObject& spot) {
        inner = spot.number("innerConeAngle").value_or(inner);
        outer = spot.number("outerConeAngle").value_or(outer);
    });
    const auto usable = [](double x) { return x >= 0.0 && x <= 1e15; };
    if (!usable(intensity) || !usable(range)) source.fault = "its intensity or range is negative or out of all measure";
    if (!usable(colour.r) || !usable(colour.g) || !usable(colour.b)) source.fault = "its color is negative";
    if (!(inner >= 0.0 && inner < outer && outer <= std::numbers::pi / 2.0)) {
        source.fault = "its cone angles are not 0 <= inner < outer <= pi / 2";
    }
    light.intensity = glm::vec3(colour * intensity);
    light.range = static_cast<float>(range);
    const double scale = 1.0 / std::max(0.001, std::cos(inner) - std::cos(outer));
    light.cone_scale = static_cast<float>(scale);
    light.cone_offset = static_cast<float>(-std::cos(outer) * scale);
    return source;
}

}  // namespace

void load_lights(const nlohmann::json& json, const Document& document, const NodeGraph& graph, Scene& scene) {
    nlohmann::json copy;
    JsonObject root(json, copy, "", document.diagnostics);
    std::vector<Source> sources;
    root.object("extensions", [&](JsonObject& extensions) {
        extensions.object(extension, [&](JsonObject& lights) {
            std::size_t i = 0;
            lights.objects("lights", [&](JsonObject& light) {
                sources.push_back(read_light(light, json["extensions"][extension]["lights"][i++]));
            });
        });
    });
    std::size_t node = 0;
    root.objects("nodes", [&](JsonObject& object) {
        const std::size_t i = node++;
        object.object("extensions", [&](JsonObject& extensions) {
            extensions.object(extension, [&](JsonObject& carried) {
                const auto index = carried.reference("light", sources.size(), Need::required);
                if (!graph.shown[i]) return;
                const Source& source = sources[static_cast<std::size_t>(*index)];
                const auto leave_out = [&](const std::string& reason) {
                    document.diagnostics.note(fmt::format("Light {} is left out: {}.", *index, reason));
                };
                if (!source.fault.empty()) return leave_out(source.fault);
                Light light = source.light;
                const glm::dmat4& world = graph.world[i];
                const glm::dvec3 back(world[2]);
                const double length = std::hypot(back.x, back.y, back.z);
                const glm::dvec3 place(world[3]);
                if (!(length > 0.0) || !std::isfinite(length) ||
                    !(std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)}) < 1e30)) {
                    return leave_out(fmt::format("the transform of nodes[{}] gives it no place or direction", i));
                }
                // Lights shine along -z.
                const glm::dvec3 unit = back / length;
                light.direction = glm::vec3(light.kind == Light::Kind::directional ? unit : -unit);
                light.place = glm::vec3(place);
                scene.lights.push_back(light);
            });
        });
    });
}

}  // namespace tessera::scene
