#include "scene/gltf_guides.hpp"

#include "scene/gltf_accessor.hpp"
#include "scene/gltf_skin.hpp"
#include "scene/limits.hpp"

#include <fmt/format.h>
#include <cmath>
#include <limits>

namespace tessera::scene {
namespace {

constexpr double largest_float = std::numeric_limits<float>::max();

bool fits_float(const glm::dvec3& v) {
    return std::abs(v.x) <= largest_float && std::abs(v.y) <= largest_float && std::abs(v.z) <= largest_float;
}

/// The normal where the transform takes it, or zero where there is none. Its length does not matter to cofactors.
glm::vec3 turned_normal(const glm::dmat4& transform, const glm::vec3& normal) {
    const glm::dmat3 m(transform);
    const glm::dmat3 cofactor{glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
    glm::dvec3 turned = cofactor * glm::dvec3(normal);
    if (glm::dot(m[0], cofactor[0]) < 0.0) turned = -turned;
    const double length = std::hypot(turned.x, turned.y, turned.z);
    if (!(length > 0.0) || !std::isfinite(length)) return glm::vec3(0.0f);
    const glm::dvec3 unit = turned / length;
    return std::isfinite(unit.x + unit.y + unit.z) ? glm::vec3(unit) : glm::vec3(0.0f);
}

/// How much larger the transform makes things, on average over directions.
double mean_scale(const glm::dmat4& transform) {
    const glm::dmat3 m(transform);
    return std::cbrt(std::abs(glm::dot(m[0], glm::cross(m[1], m[2]))));
}

std::vector<float> read_widths(const Document& document, const SourcePrimitive& source) {
    const auto it = source.primitive->attributes.find("_WIDTH");
    if (it == source.primitive->attributes.end()) return {};
    const auto& accessor = document.model.accessors[static_cast<std::size_t>(it->second)];
    if (accessor.type != TINYGLTF_TYPE_SCALAR || accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
        document.diagnostics.note(
            fmt::format("{}: its attribute _WIDTH is no SCALAR of floats and is ignored.", source.element));
        return {};
    }
    return read_floats(document, it->second);
}

/// What was left out of a primitive.
struct Dropped {
    std::size_t unsound = 0, long_ones = 0, short_ones = 0, repeated = 0, widths = 0;
};

void note(const Document& document, const std::string& element, const Dropped& dropped) {
    const auto say = [&](std::size_t count, std::string_view what) {
        if (count > 0) document.diagnostics.note(fmt::format("{}: {} {}.", element, count, what));
    };
    say(dropped.unsound, "guide curves have positions that are not finite and are left out");
    say(dropped.long_ones, fmt::format("guide curves have more than {} points and are left out", max_guide_points));
    say(dropped.short_ones, "guide curves have no two different points and are left out");
    say(dropped.repeated, "points of guide curves repeat the one before and are left out");
    say(dropped.widths, "widths are negative or not finite and became zero");
}

}  // namespace

void read_guides(const Document& document, std::span<const std::uint32_t> indices, SourcePrimitive& out) {
    if (indices.size() < 2) {
        document.diagnostics.note(
            fmt::format("{} is a line of {} points and is skipped.", out.element, indices.size()));
        return;
    }
    if (out.primitive->mode == TINYGLTF_MODE_LINE_STRIP) {
        out.guide_points.assign(indices.begin(), indices.end());
        out.guide_ends.push_back(static_cast<std::uint32_t>(indices.size()));
        return;
    }
    for (std::size_t i = 0; i + 1 < indices.size(); i += 2) {
        if (i == 0 || indices[i] != indices[i - 1]) {
            if (i > 0) out.guide_ends.push_back(static_cast<std::uint32_t>(out.guide_points.size()));
            out.guide_points.push_back(indices[i]);
        }
        out.guide_points.push_back(indices[i + 1]);
    }
    out.guide_ends.push_back(static_cast<std::uint32_t>(out.guide_points.size()));
    if (indices.size() % 2 != 0) {
        document.diagnostics.note(
            fmt::format("{} has {} indices, not a multiple of two: the rest is skipped.", out.element, indices.size()));
    }
}

void bake_guides(const Document& document, const SourcePrimitive& source, const Pose& pose, Guides& out) {
    const std::vector<float> widths = read_widths(document, source);
    const bool skinned = !pose.joints.empty() && source.influences > 0;
    if (skinned) check_influences(document, source, pose.joints.size());
    if (!pose.morph_weights.empty()) {
        document.diagnostics.note(fmt::format("{}: the morph targets of its lines are ignored.", source.element));
    }
    Dropped dropped;
    std::size_t begin = 0;
    for (const std::uint32_t end : source.guide_ends) {
        const std::size_t first = out.points.size();
        bool sound = end - begin <= max_guide_points;
        dropped.long_ones += sound ? 0 : 1;
        for (std::size_t i = begin; i < end && sound; ++i) {
            const std::uint32_t v = source.guide_points[i];
            const glm::dmat4 transform = skinned ? blended_matrix(source, pose.joints, v) : pose.world;
            const glm::dvec3 world(transform * glm::dvec4(glm::dvec3(source.positions[v]), 1.0));
            if (!fits_float(world)) {
                sound = false;
                ++dropped.unsound;
                break;
            }
            const glm::vec3 point = glm::vec3(world) + 0.0f;  // no negative zeros
            if (out.points.size() > first && out.points.back() == point) {
                ++dropped.repeated;
                continue;
            }
            out.points.push_back(point);
            out.normals.push_back(source.normals.empty() ? glm::vec3(0.0f)
                                                         : turned_normal(transform, source.normals[v]));
            const double width = widths.empty() ? no_width : widths[v] * mean_scale(transform);
            const bool usable = widths.empty() || (width >= 0.0 && width <= largest_float);
            dropped.widths += usable ? 0 : 1;
            out.widths.push_back(usable ? static_cast<float>(width) : 0.0f);
        }
        begin = end;
        if (sound && out.points.size() >= first + 2) {
            out.ends.push_back(static_cast<std::uint32_t>(out.points.size()));
            continue;
        }
        dropped.short_ones += sound ? 1 : 0;
        out.points.resize(first);
        out.normals.resize(first);
        out.widths.resize(first);
    }
    note(document, source.element, dropped);
}

}  // namespace tessera::scene
