#include "scene/gltf_shape_tags.hpp"

#include "scene/gltf_accessor.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <string>

namespace tessera::scene {
namespace {

/// Counts the values that had to be changed.
class Range {
public:
    float clamped(float value, float least, float greatest) {
        if (!std::isfinite(value)) {
            ++unsound_;
            return 0.0f;
        }
        const float inside = std::clamp(value, least, greatest);
        outside_ += inside == value ? 0 : 1;
        return inside + 0.0f;
    }

    void note(const std::string& what, Diagnostics& diagnostics) const {
        if (unsound_ > 0)
            diagnostics.note(fmt::format("{}: {} values are not finite and became zero.", what, unsound_));
        if (outside_ > 0) diagnostics.note(fmt::format("{}: {} values are out of range and clamped.", what, outside_));
    }

private:
    std::size_t unsound_ = 0;
    std::size_t outside_ = 0;
};

/// The numbers of an attribute, or none where the file has it not or as something else.
std::vector<float> numbers(const Document& document, const SourcePrimitive& out, const char* name, int type) {
    const auto found = out.primitive->attributes.find(name);
    if (found == out.primitive->attributes.end()) return {};
    if (document.model.accessors[static_cast<std::size_t>(found->second)].type != type) {
        document.diagnostics.note(fmt::format("{}: its {} is not a {} and is left out.", out.element, name,
                                              type == TINYGLTF_TYPE_SCALAR ? "SCALAR" : "VEC3"));
        return {};
    }
    return read_floats(document, found->second);
}

}  // namespace

void read_shape_tags(const Document& document, const tinygltf::Mesh& mesh, SourcePrimitive& out) {
    Range alphas;
    for (const float alpha : numbers(document, out, "_ALPHA", TINYGLTF_TYPE_SCALAR))
        out.alphas.push_back(alphas.clamped(alpha, 0.0f, 1.0f));
    alphas.note(out.element + ": _ALPHA", document.diagnostics);
    if (out.alphas.empty() && mesh.extras.Has("alpha")) {
        Range extra;
        const double alpha = std::clamp(mesh.extras.Get("alpha").GetNumberAsDouble(), -1.0, 2.0);  // fits a float
        out.alphas.assign(out.positions.size(), extra.clamped(static_cast<float>(alpha), 0.0f, 1.0f));
        extra.note(out.element + ": alpha in the extras of its mesh", document.diagnostics);
    }
    Range tags;
    for (const glm::vec3& t : as_vec3(numbers(document, out, "_STPN", TINYGLTF_TYPE_VEC3)))
        out.stpn.emplace_back(tags.clamped(t.x, 0.0f, 1.0f), tags.clamped(t.y, -1.0f, 1.0f),
                              tags.clamped(t.z, -1.0f, 1.0f));
    tags.note(out.element + ": _STPN", document.diagnostics);
}

}  // namespace tessera::scene
