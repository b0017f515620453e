#include "scene/gltf_vertex_attributes.hpp"

#include "scene/gltf_accessor.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <string>

namespace tessera::scene {
namespace {

int attribute(const SourcePrimitive& out, const char* name) {
    const auto found = out.primitive->attributes.find(name);
    return found == out.primitive->attributes.end() ? -1 : found->second;
}

void read_colors(const Document& document, SourcePrimitive& out) {
    const int accessor = attribute(out, "COLOR_0");
    if (accessor < 0) return;
    const std::vector<float> numbers = read_floats(document, accessor);
    const auto components =
        static_cast<std::size_t>(components_of(document.model.accessors[static_cast<std::size_t>(accessor)]));
    std::size_t unsound = 0;
    std::size_t outside = 0;
    out.colors.assign(out.positions.size(), glm::vec4(1.0f));
    for (std::size_t i = 0; i < out.colors.size(); ++i) {
        for (std::size_t c = 0; c < components; ++c) {
            const float value = numbers[components * i + c];
            if (!std::isfinite(value)) {
                ++unsound;  // stays 1
                continue;
            }
            const float inside = std::clamp(value, 0.0f, 1.0f);
            outside += inside == value ? 0 : 1;
            out.colors[i][static_cast<int>(c)] = inside + 0.0f;
        }
    }
    if (unsound > 0) {
        document.diagnostics.note(
            fmt::format("{}: {} values of COLOR_0 are not finite and became 1.", out.element, unsound));
    }
    if (outside > 0) {
        document.diagnostics.note(
            fmt::format("{}: {} values of COLOR_0 are outside [0, 1] and clamped.", out.element, outside));
    }
}

void read_tangents(const Document& document, SourcePrimitive& out) {
    const int accessor = attribute(out, "TANGENT");
    if (accessor < 0) return;
    if (out.normals.empty()) {
        // glTF 2.0, section 3.7.2.1: without normals, tangents are to be ignored.
        document.diagnostics.note(fmt::format("{}: it has no NORMAL, so its TANGENT is left out.", out.element));
        return;
    }
    const std::vector<float> numbers = read_floats(document, accessor);
    out.tangents.resize(out.positions.size());
    for (std::size_t i = 0; i < out.tangents.size(); ++i)
        out.tangents[i] = {numbers[4 * i], numbers[4 * i + 1], numbers[4 * i + 2], numbers[4 * i + 3]};
}

}  // namespace

void read_vertex_attributes(const Document& document, SourcePrimitive& out) {
    read_colors(document, out);
    read_tangents(document, out);
    if (attribute(out, "COLOR_1") >= 0) {
        document.diagnostics.note(fmt::format("{}: COLOR_1 and further colours are left out.", out.element));
    }
}

}  // namespace tessera::scene
