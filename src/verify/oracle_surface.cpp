#include "verify/oracle.hpp"

#include "base/error.hpp"
#include "tessellate/tessellate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace tessera::verify {
namespace {

constexpr std::size_t patches_per_draw = 256;

using DoubleTriple = std::array<double, 3>;

/// Squares of floats cannot overflow in double. Not std::hypot: that of libstdc++ 12 gives 0 for (0, NaN, 0).
double length(const DoubleTriple& v) {
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

double largest_coordinate(std::span<const Vertex> corners) {
    double largest = 0.0;
    for (const Vertex& corner : corners) {
        for (const float coordinate : corner.position) {
            largest = std::max(largest, std::fabs(static_cast<double>(coordinate)));
        }
    }
    return largest > 0.0 ? largest : 1.0;
}

double position_error(const Vertex& ours, const Triple& theirs) {
    DoubleTriple d;
    for (std::size_t i = 0; i < 3; ++i) {
        d[i] = static_cast<double>(ours.position[i]) - static_cast<double>(theirs[i]);
    }
    return length(d);
}

/// Distance of the unit normals, times the length of the blended one.
double normal_error(const Vertex& ours, const Triple& blended) {
    const DoubleTriple b{blended[0], blended[1], blended[2]};
    const double size = length(b);
    DoubleTriple d;
    for (std::size_t i = 0; i < 3; ++i) {
        d[i] = static_cast<double>(ours.normal[i]) * size - b[i];
    }
    return length(d);
}

/// Some patches by themselves: their corners, three each, and the kernels' job over them.
struct Slice {
    patches::PatchSet patches;
    std::vector<PatchFactors> factors;

    Slice(const patches::PatchSet& all, const TessellationOptions& options, std::size_t first, std::size_t count) {
        for (std::size_t i = first; i < first + count; ++i) {
            const auto base = static_cast<std::uint32_t>(patches.control_vertices.size());
            for (std::size_t k = 0; k < 3; ++k) {
                patches.control_vertices.push_back(all.control_vertices[all.corners[i][k]]);
            }
            patches.corners.push_back({base, base + 1, base + 2, patches::no_corner});
        }
        patches.ranges.push_back({"oracle", 0, 0, count});
        patches.exponent = all.exponent;
        if (const auto* one = std::get_if<PatchFactors>(&options.factors)) {
            factors.assign(count, *one);
        } else {
            const auto& list = std::get<std::vector<PatchFactors>>(options.factors);
            factors.assign(list.begin() + static_cast<std::ptrdiff_t>(first),
                           list.begin() + static_cast<std::ptrdiff_t>(first + count));
        }
    }
    std::span<const Vertex> corners(std::size_t patch) const {
        return std::span(patches.control_vertices).subspan(3 * patch, 3);
    }
};

/// The kernels' vertices of a slice, in the space of the kernels.
std::vector<Vertex> evaluate(const gpu::Device& device, const Slice& slice, TessellationOptions options) {
    options.factors = slice.factors;
    RefinedMesh mesh;
    Tessellator(device, slice.patches, options).run(mesh, Space::kernel);
    return std::move(mesh.vertices);
}

/// Adds one patch to the result; returns what is wrong with it, or nothing.
std::string compare_patch(const Pattern& pattern, std::span<const Vertex> vertices, const CapturedPatch& captured,
                          double scale, SurfaceComparison& result) {
    std::unordered_map<std::uint64_t, const Vertex*> at;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        at.emplace(std::uint64_t{pattern.points[i].u} << 32 | pattern.points[i].v, &vertices[i]);
    }
    if (captured.coordinates.size() != pattern.indices.size()) {
        return fmt::format("{} triangles by the kernels, {} by the stage", pattern.indices.size() / 3,
                           captured.coordinates.size() / 3);
    }
    std::string problem;
    for (std::size_t i = 0; i < captured.coordinates.size(); ++i) {
        const auto point = domain_point(captured.coordinates[i], Domain::triangle);
        const auto found = point ? at.find(std::uint64_t{point->u} << 32 | point->v) : at.end();
        if (found == at.end()) {
            return fmt::format("the kernels have no vertex at ({:a}, {:a})", captured.coordinates[i][0],
                               captured.coordinates[i][1]);
        }
        const double position = position_error(*found->second, captured.points[i].position) / scale;
        const double normal = normal_error(*found->second, captured.points[i].normal);
        ++result.vertices;
        result.position_error = std::max(result.position_error, position);
        result.normal_error = std::max(result.normal_error, normal);
        // Written so that a NaN is wrong as well.
        if (problem.empty() && !(position <= position_error_bound && normal <= normal_error_bound)) {
            const Vertex& ours = *found->second;
            const CapturedPoint& theirs = captured.points[i];
            problem = fmt::format(
                "at ({}, {}) of 65536 position {} by the kernels, {} by the stage, error {:.3g}; normal {}, "
                "blended {}, error {:.3g}",
                point->u, point->v, fmt::join(ours.position, ","), fmt::join(theirs.position, ","), position,
                fmt::join(ours.normal, ","), fmt::join(theirs.normal, ","), normal);
        }
    }
    return problem;
}

}  // namespace

SurfaceComparison compare_surface(FixedFunctionTessellator& stage, const gpu::Device& device,
                                  const patches::PatchSet& patches, const TessellationOptions& options,
                                  const std::function<void(double)>& progress) {
    const auto* list = std::get_if<std::vector<PatchFactors>>(&options.factors);
    if (list != nullptr && list->size() != patches.patch_count()) {
        throw Error(ErrorKind::usage, fmt::format("There are {} sets of tessellation factors for {} patches; give one "
                                                  "set, or one per patch.",
                                                  list->size(), patches.patch_count()));
    }
    if (patches.has_quads) {
        throw Error(ErrorKind::usage,
                    "The fixed-function stage evaluates triangle patches only, and this model has quads; "
                    "compare its devices with `tessera verify` instead.");
    }
    if (options.normals == Normals::surface) {
        throw Error(ErrorKind::usage,
                    "The fixed-function stage is asked for linear and quadratic normals only; compare true normals "
                    "between devices with `tessera verify` instead.");
    }
    if (options.scheme == Scheme::stpn || (options.scheme == Scheme::phong && !patches.vertex_tags.empty())) {
        throw Error(
            ErrorKind::usage,
            fmt::format("The fixed-function stage knows no tags of vertices, which {} of this model uses; compare "
                        "its devices with `tessera verify` instead.",
                        name(options.scheme)));
    }
    const CapturedSurface surface{options.scheme, options.normals, options.alpha};
    SurfaceComparison result;
    for (std::size_t first = 0; first < patches.patch_count(); first += patches_per_draw) {
        const std::size_t count = std::min<std::size_t>(patches_per_draw, patches.patch_count() - first);
        const Slice slice(patches, options, first, count);
        const auto captured =
            stage.evaluate(surface, options.partitioning, slice.factors, slice.patches.control_vertices);
        const auto patterns = make_patterns(device, Domain::triangle, options.partitioning, true, slice.factors);
        const std::vector<Vertex> vertices = evaluate(device, slice, options);
        std::size_t start = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const auto own = std::span(vertices).subspan(start, patterns[i].points.size());
            start += own.size();
            if (culled_by_flushing(captured[i], Domain::triangle, slice.factors[i])) {
                continue;
            }
            const std::string problem =
                compare_patch(patterns[i], own, captured[i], largest_coordinate(slice.corners(i)), result);
            if (!problem.empty() && result.differing++ == 0) {
                result.first = fmt::format("patch {}, {} with {} normals, {}, factors {}: {}", first + i,
                                           name(options.scheme), name(options.normals), name(options.partitioning),
                                           fmt::join(slice.factors[i], ","), problem);
            }
        }
        result.patches += count;
        if (progress) {
            progress(static_cast<double>(first + count) / static_cast<double>(patches.patch_count()));
        }
    }
    return result;
}

}  // namespace tessera::verify
