#include "tessellate/welded.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstring>
#include <numeric>

namespace tessera::test {

WeldedMesh weld(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices, WeldBy by) {
    const std::size_t bytes =
        by == WeldBy::position ? sizeof(Vertex::position) : sizeof(Vertex::position) + sizeof(Vertex::normal);
    const auto compare = [&](std::uint32_t a, std::uint32_t b) {
        return std::memcmp(&vertices[a], &vertices[b], bytes);
    };
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return compare(a, b) < 0; });
    std::vector<std::uint32_t> welded(vertices.size());
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        next += i > 0 && compare(order[i - 1], order[i]) != 0 ? 1u : 0u;
        welded[order[i]] = next;
    }
    WeldedMesh mesh;
    mesh.triangles.reserve(indices.size());
    for (std::size_t t = 0; t < indices.size(); t += 3) {
        const std::uint32_t a = welded[indices[t]];
        const std::uint32_t b = welded[indices[t + 1]];
        const std::uint32_t c = welded[indices[t + 2]];
        if (a == b || b == c || c == a) {
            ++mesh.collapsed;
        } else {
            mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
        }
    }
    return mesh;
}

std::string find_crack(const WeldedMesh& mesh, bool manifold) {
    // Both directions of an edge side by side: lower vertex, higher vertex, direction.
    std::vector<std::uint64_t> edges;
    edges.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t a = mesh.triangles[t + k];
            const std::uint64_t b = mesh.triangles[t + (k + 1) % 3];
            edges.push_back(std::min(a, b) << 32 | std::max(a, b) << 1 | (a < b ? 0u : 1u));
        }
    }
    std::ranges::sort(edges);
    std::size_t unpaired = 0;
    std::string first;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t count[2] = {0, 0};
        const std::uint64_t edge = edges[i] >> 1;
        for (; i < edges.size() && edges[i] >> 1 == edge; ++i) {
            ++count[edges[i] & 1u];
        }
        if ((count[0] != count[1] || (manifold && count[0] != 1)) && unpaired++ == 0) {
            first = fmt::format("edge {} - {} comes {} times one way and {} times the other", edge >> 31,
                                edge & 0x7fffffffu, count[0], count[1]);
        }
    }
    return unpaired == 0 ? "" : fmt::format("{} edges: {}", unpaired, first);
}

}  // namespace tessera::test
