#include "verify/oracle.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>

namespace tessera::verify {
namespace {

constexpr std::size_t patches_per_run = 256;
constexpr float grid = 65536.0f;

/// Corners as u << 32 | v; the third of a segment is zero.
using Primitive = std::array<std::uint64_t, 3>;

std::uint64_t code(DomainPoint point) {
    return std::uint64_t{point.u} << 32 | point.v;
}

/// A triangle starts anywhere without change of winding, a segment has no direction.
Primitive canonical(Primitive primitive, std::size_t corners) {
    if (corners == 2) {
        std::sort(primitive.begin(), primitive.begin() + 2);
    } else {
        std::rotate(primitive.begin(), std::ranges::min_element(primitive), primitive.end());
        // With a corner named twice, the least one can come first in two ways.
        const Primitive turned{primitive[1], primitive[2], primitive[0]};
        const Primitive back{primitive[2], primitive[0], primitive[1]};
        primitive = std::min({primitive, turned, back});
    }
    return primitive;
}

std::vector<Primitive> sorted_primitives(std::span<const DomainPoint> listed, std::size_t corners) {
    std::vector<Primitive> primitives(listed.size() / corners);
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        for (std::size_t k = 0; k < corners; ++k) {
            primitives[i][k] = code(listed[i * corners + k]);
        }
        primitives[i] = canonical(primitives[i], corners);
    }
    std::ranges::sort(primitives);
    return primitives;
}

std::string describe(const Primitive& primitive, std::size_t corners) {
    std::vector<std::string> words;
    for (std::size_t k = 0; k < corners; ++k) {
        words.push_back(fmt::format("({},{})", primitive[k] >> 32, primitive[k] & 0xffffffffu));
    }
    return fmt::format("{}", fmt::join(words, " "));
}

/// What `a` has and `b` has not, at most a few.
std::string only_in(const std::vector<Primitive>& a, const std::vector<Primitive>& b, std::size_t corners) {
    std::vector<Primitive> rest;
    std::ranges::set_difference(a, b, std::back_inserter(rest));
    std::vector<std::string> words;
    for (std::size_t i = 0; i < std::min<std::size_t>(rest.size(), 3); ++i) {
        words.push_back(describe(rest[i], corners));
    }
    return rest.empty() ? "none"
                        : fmt::format("{}: {}{}", rest.size(), fmt::join(words, ", "), rest.size() > 3 ? ", ..." : "");
}

/// Empty where both agree, else what differs.
std::string difference(const Pattern& pattern, const CapturedPatch& captured, Domain domain,
                       const PatchFactors& factors) {
    if (culled_by_flushing(captured, domain, factors)) {
        return {};
    }
    const std::size_t corners = domain == Domain::isoline ? 2 : 3;
    std::vector<DomainPoint> expected, found;
    for (const std::uint32_t index : pattern.indices) {
        expected.push_back(pattern.points[index]);
    }
    for (const Triple& coordinates : captured.coordinates) {
        const auto point = domain_point(coordinates, domain);
        if (!point) {
            return fmt::format("the stage's coordinates ({:a}, {:a}, {:a}) are no domain point", coordinates[0],
                               coordinates[1], coordinates[2]);
        }
        found.push_back(*point);
    }
    const std::vector<Primitive> ours = sorted_primitives(expected, corners);
    const std::vector<Primitive> theirs = sorted_primitives(found, corners);
    if (ours == theirs) {
        return {};
    }
    return fmt::format("{} {} by the kernels, {} by the stage; only by the kernels {}; only by the stage {}",
                       ours.size(), corners == 2 ? "segments" : "triangles", theirs.size(),
                       only_in(ours, theirs, corners), only_in(theirs, ours, corners));
}

}  // namespace

std::optional<DomainPoint> domain_point(const Triple& coordinates, Domain domain) {
    // Exact: a product with a power of two, and integers up to 2^16.
    std::array<std::uint32_t, 3> fixed{};
    for (std::size_t i = 0; i < 3; ++i) {
        const float scaled = coordinates[i] * grid;
        if (!(scaled >= 0.0f && scaled <= grid)) {  // NaN too
            return std::nullopt;
        }
        fixed[i] = static_cast<std::uint32_t>(scaled);
        if (static_cast<float>(fixed[i]) != scaled) {
            return std::nullopt;
        }
    }
    const bool sound = domain == Domain::triangle ? fixed[0] + fixed[1] + fixed[2] == 65536u : fixed[2] == 0u;
    return sound ? std::optional(DomainPoint{fixed[0], fixed[1]}) : std::nullopt;
}

bool culled_by_flushing(const CapturedPatch& captured, Domain domain, const PatchFactors& factors) {
    const auto outer = factors.begin() + (domain == Domain::triangle ? 3 : (domain == Domain::quad ? 4 : 2));
    return captured.coordinates.empty() && std::any_of(factors.begin(), outer, [](float factor) {
               return factor > 0.0f && std::fpclassify(factor) == FP_SUBNORMAL;
           });
}

DomainComparison compare_domain(FixedFunctionTessellator& stage, const gpu::Device& device, Domain domain,
                                Partitioning partitioning, bool clockwise, std::span<const PatchFactors> factors) {
    DomainComparison result;
    for (std::size_t first = 0; first < factors.size(); first += patches_per_run) {
        const auto run = factors.subspan(first, std::min(patches_per_run, factors.size() - first));
        const std::vector<CapturedPatch> captured = stage.tessellate(domain, partitioning, clockwise, run);
        const std::vector<Pattern> patterns = make_patterns(device, domain, partitioning, clockwise, run);
        for (std::size_t i = 0; i < run.size(); ++i) {
            ++result.patches;
            result.primitives += patterns[i].indices.size() / (domain == Domain::isoline ? 2 : 3);
            const std::string what = difference(patterns[i], captured[i], domain, run[i]);
            if (!what.empty() && result.differing++ == 0) {
                result.first = fmt::format("{} {} {}, factors {}: {}", name(domain), name(partitioning),
                                           clockwise ? "cw" : "ccw", fmt::join(run[i], ","), what);
            }
        }
    }
    return result;
}

}  // namespace tessera::verify
