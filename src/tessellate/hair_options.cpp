#include "tessellate/hair_options.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <cmath>

namespace tessera {
namespace {

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

std::string_view name(Ribbons ribbons) {
    return ribbons == Ribbons::camera ? "camera" : "flat";
}

Ribbons ribbons_from_name(std::string_view name) {
    if (name == "camera") return Ribbons::camera;
    if (name == "flat") return Ribbons::flat;
    throw Error(ErrorKind::usage, fmt::format("There are no ribbons named \"{}\"; choose camera or flat.", name));
}

void check(const HairOptions& options) {
    if (options.hairs < 1 || options.hairs > most_hairs_per_patch) {
        throw Error(ErrorKind::usage, fmt::format("{} hairs per patch are asked for; the number must lie in [1, {}].",
                                                  options.hairs, most_hairs_per_patch));
    }
    if (options.segments < 1 || options.segments > most_hair_segments) {
        throw Error(ErrorKind::usage, fmt::format("{} segments per hair are asked for; the number must lie in [1, {}].",
                                                  options.segments, most_hair_segments));
    }
    if (!(options.taper >= 0.0f && options.taper <= 1.0f)) {
        throw Error(ErrorKind::usage, fmt::format("The taper of hair is {}; it must lie in [0, 1].", options.taper));
    }
    if (!(options.variation >= 0.0f && options.variation <= 1.0f)) {
        throw Error(ErrorKind::usage, fmt::format("The variation of the length of hair is {}; it must lie in [0, 1].",
                                                  options.variation));
    }
    if (!is_finite(options.eye) || !is_finite(options.direction) || options.direction == glm::vec3(0.0f)) {
        throw Error(ErrorKind::usage, "Ribbons need an eye and a direction of finite numbers, the latter not zero.");
    }
}

}  // namespace tessera
