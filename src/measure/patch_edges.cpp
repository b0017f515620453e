#include "measure/patch_edges.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <cstring>
#include <map>
#include <optional>

namespace tessera::measure {
namespace {

using Bits = std::array<std::uint32_t, 3>;

Bits bits_of(const float (&v)[3]) {
    return {std::bit_cast<std::uint32_t>(v[0]), std::bit_cast<std::uint32_t>(v[1]), std::bit_cast<std::uint32_t>(v[2])};
}

/// A use of an edge by a patch, seen from the end whose position sorts first.
struct Use {
    PatchEdge edge;
    bool forward = true;
    std::array<Bits, 2> normals;
};

/// How far along its edge a domain point lies, 0..65536, or nothing where it is not on the edge.
std::optional<std::uint32_t> along_edge(const DomainPoint& p, bool quad, std::uint32_t edge) {
    constexpr std::uint32_t one = 65536;
    if (quad) {
        const bool on[4] = {p.v == 0, p.u == one, p.v == one, p.u == 0};
        const std::uint32_t at[4] = {p.u, p.v, one - p.u, one - p.v};
        return on[edge] ? std::optional(at[edge]) : std::nullopt;
    }
    const std::uint32_t w = one - p.u - p.v;  // corners 0, 1, 2 are at u, v, w = 1
    const bool on[3] = {w == 0, p.u == 0, p.v == 0};
    const std::uint32_t at[3] = {p.v, w, p.u};
    return on[edge] ? std::optional(at[edge]) : std::nullopt;
}

}  // namespace

PatchEdges find_edges(const patches::PatchSet& patches) {
    PatchEdges edges;
    std::map<std::array<Bits, 2>, std::vector<Use>> uses;
    for (std::uint32_t p = 0; p < patches.corners.size(); ++p) {
        const patches::PatchCorners& corners = patches.corners[p];
        const std::uint32_t count = patches::is_quad(corners) ? 4 : 3;
        for (std::uint32_t e = 0; e < count; ++e) {
            const Vertex& from = patches.control_vertices[corners[e]];
            const Vertex& to = patches.control_vertices[corners[(e + 1) % count]];
            std::array<Bits, 2> ends{bits_of(from.position), bits_of(to.position)};
            Use use{{p, e}, ends[0] < ends[1], {bits_of(from.normal), bits_of(to.normal)}};
            if (ends[0] == ends[1]) {
                ++edges.without_length;
                continue;
            }
            if (!use.forward) {
                std::swap(ends[0], ends[1]);
                std::swap(use.normals[0], use.normals[1]);
            }
            uses[ends].push_back(use);
        }
    }
    for (const auto& [ends, list] : uses) {
        if (list.size() == 1) {
            ++edges.boundary;
        } else if (list.size() > 2) {
            ++edges.crowded;
        } else if (list[0].normals != list[1].normals) {
            ++edges.split;
        } else {
            edges.smooth.push_back({{list[0].edge, list[1].edge}, list[0].forward != list[1].forward});
        }
    }
    return edges;
}

std::vector<std::uint32_t> points_on_edge(const Pattern& pattern, bool quad, std::uint32_t edge) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;  // place, index
    for (std::uint32_t i = 0; i < pattern.points.size(); ++i) {
        if (const auto at = along_edge(pattern.points[i], quad, edge)) found.emplace_back(*at, i);
    }
    std::ranges::sort(found);
    std::vector<std::uint32_t> points;
    for (const auto& [at, index] : found)
        points.push_back(index);
    return points;
}

AngleStatistics discontinuity(const PatchSurface& surface, const PatchEdges& edges) {
    std::array<std::array<std::vector<std::uint32_t>, 4>, 2> points;  // by domain and edge
    for (std::uint32_t e = 0; e < 4; ++e) {
        if (e < 3) points[0][e] = points_on_edge(surface.triangle, false, e);
        points[1][e] = points_on_edge(surface.quad, true, e);
    }
    std::vector<double> angles;
    for (const SharedEdge& shared : edges.smooth) {
        std::array<const std::vector<std::uint32_t>*, 2> lists{};
        std::array<std::span<const Vertex>, 2> vertices;
        for (std::size_t s = 0; s < 2; ++s) {
            const PatchEdge& side = shared.sides[s];
            lists[s] = &points[surface.quads[side.patch] ? 1 : 0][side.edge];
            vertices[s] = surface.patch_vertices(side.patch);
        }
        const std::size_t count = lists[0]->size();
        for (std::size_t i = 0; i < count && count == lists[1]->size(); ++i) {
            const Vertex& a = vertices[0][(*lists[0])[i]];
            const Vertex& b = vertices[1][(*lists[1])[shared.reversed ? count - 1 - i : i]];
            if (std::memcmp(a.position, b.position, sizeof a.position) != 0) {
                throw Error(ErrorKind::usage,
                            fmt::format("Patches {} and {} share an edge, but the surface has a crack there.",
                                        shared.sides[0].patch, shared.sides[1].patch));
            }
            angles.push_back(angle_between(a.normal, b.normal));
        }
    }
    return summarise(std::move(angles));
}

}  // namespace tessera::measure
