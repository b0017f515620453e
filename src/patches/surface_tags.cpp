#include "patches/surface_tags.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>
#include <unordered_map>

namespace tessera::patches {
namespace {

using glm::dvec3;

constexpr std::size_t most_fans = 64;  // their paths are compared each with each
constexpr float least_tag = 0x1p-24f;

float flush_tag(float x) {
    return std::fabs(x) < least_tag ? 0.0f : x;
}

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

/// The same number for vertices at the same position.
std::vector<std::uint32_t> number_positions(std::span<const Vertex> vertices) {
    const auto compare = [&](std::uint32_t a, std::uint32_t b) {
        return std::memcmp(vertices[a].position, vertices[b].position, sizeof(Vertex::position));
    };
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return compare(a, b) < 0; });
    std::vector<std::uint32_t> numbers(vertices.size());
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        next += i > 0 && compare(order[i - 1], order[i]) != 0 ? 1u : 0u;
        numbers[order[i]] = next;
    }
    return numbers;
}

dvec3 position(const Vertex& v) {
    return {v.position[0], v.position[1], v.position[2]};
}

void store_unit(const dvec3& v, const float (&otherwise)[3], float (&to)[3]) {
    const double length = glm::length(v);
    const bool usable = length > 1e-12;
    for (int i = 0; i < 3; ++i) {
        const auto x = usable ? static_cast<float>(v[i] / length) : otherwise[i];
        to[i] = std::fabs(x) < 0x1p-60f ? 0.0f : x;
    }
}

/// A corner of a patch at some position, and the ends of its two edges there.
struct Incident {
    std::uint32_t patch = 0, corner = 0;
    std::uint32_t next = 0, previous = 0;  // positions
    dvec3 normal{};                        // of the face, times the angle at the corner
};

/// The faces around one position, fan by fan: fans are what smooth edges join.
class Surroundings {
public:
    using Creases = std::unordered_map<std::uint64_t, float>;

    Surroundings(std::uint32_t at, std::span<const Incident> corners, const Creases& creases)
        : corners_(corners), parent_(corners.size()) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
        std::vector<std::pair<std::uint32_t, std::size_t>> ends;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            ends.emplace_back(corners[i].next, i);
            ends.emplace_back(corners[i].previous, i);
        }
        std::ranges::sort(ends);
        struct Link {
            std::size_t a, b;
            double share;
        };
        std::vector<Link> links;
        for (std::size_t i = 1; i < ends.size(); ++i) {
            if (ends[i - 1].first != ends[i].first) continue;
            const auto crease = creases.find(edge_key(at, ends[i].first));
            if (crease == creases.end()) {
                parent_[root(ends[i].second)] = root(ends[i - 1].second);
            } else {
                links.push_back({ends[i - 1].second, ends[i].second, 1.0 - static_cast<double>(crease->second)});
            }
        }
        fan_.resize(corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::size_t top = root(i);
            if (top == i) fan_[i] = fans_++;
        }
        sums_.resize(fans_);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            fan_[i] = fan_[root(i)];
            sums_[fan_[i]] += corners[i].normal;
        }
        if (fans_ > most_fans) return;
        // The best way from fan to fan: how much of the other side counts (Floyd and Warshall, by products).
        shares_.assign(fans_ * fans_, 0.0);
        for (std::size_t i = 0; i < fans_; ++i)
            share(i, i) = 1.0;
        for (const Link& link : links) {
            const std::size_t a = fan_[link.a];
            const std::size_t b = fan_[link.b];
            share(a, b) = share(b, a) = std::max(share(a, b), link.share);
        }
        for (std::size_t k = 0; k < fans_; ++k)
            for (std::size_t i = 0; i < fans_; ++i)
                for (std::size_t j = 0; j < fans_; ++j)
                    share(i, j) = std::max(share(i, j), share(i, k) * share(k, j));
    }

    /// The sum whose direction is the normal of corner i.
    dvec3 normal(std::size_t i) const {
        if (shares_.empty()) return sums_[fan_[i]];
        dvec3 sum(0.0);
        for (std::size_t j = 0; j < fans_; ++j)
            sum += sums_[j] * shares_[fan_[i] * fans_ + j];
        return sum;
    }
    dvec3 smooth_normal() const { return std::accumulate(sums_.begin(), sums_.end(), dvec3(0.0)); }
    /// A corner that stands for the fan of corner i, the same for all of them.
    std::size_t leader(std::size_t i) const {
        return static_cast<std::size_t>(std::ranges::find(fan_, fan_[i]) - fan_.begin());
    }

private:
    std::size_t root(std::size_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    double& share(std::size_t a, std::size_t b) { return shares_[a * fans_ + b]; }

    std::span<const Incident> corners_;
    std::vector<std::size_t> parent_, fan_;
    std::size_t fans_ = 0;
    std::vector<dvec3> sums_;
    std::vector<double> shares_;
};

class CreaseBuilder {
public:
    CreaseBuilder(const scene::Scene& scene, PatchSet& set)
        : set_(set), number_(number_positions(set.control_vertices)) {
        std::size_t base = 0;
        for (const scene::Mesh& mesh : scene.meshes) {
            for (const scene::Crease& crease : mesh.tags.creases)
                add_crease(base, crease);
            for (const scene::SharpVertex& corner : mesh.tags.corners) {
                float& sharpness = corners_[number_[base + corner.vertex]];
                sharpness = std::max(sharpness, crease_share(corner.sharpness));
            }
            base += mesh.positions.size();
        }
    }

    void build() {
        for (std::size_t v = 0; v < number_.size(); ++v) {
            VertexTags& tags = set_.vertex_tags[v];
            if (const auto corner = corners_.find(number_[v]); corner != corners_.end()) {
                tags.sharpness = std::max(tags.sharpness, corner->second);
            }
        }
        if (creases_.empty()) return;
        set_.corner_tags.resize(set_.corners.size());
        for (std::size_t p = 0; p < set_.corners.size(); ++p)
            visit(static_cast<std::uint32_t>(p));
        for (const auto& [at, incidents] : incidents_)
            set_normals(at, incidents);
        for (std::size_t v = 0; v < number_.size(); ++v)
            finish_vertex(v);
    }

private:
    void add_crease(std::size_t base, const scene::Crease& crease) {
        const float share = crease_share(crease.sharpness);
        const std::uint32_t a = number_[base + crease.a];
        const std::uint32_t b = number_[base + crease.b];
        if (share == 0.0f || a == b) return;
        const auto [entry, is_new] = creases_.try_emplace(edge_key(a, b), share);
        entry->second = std::max(entry->second, share);
        if (!is_new) return;
        const auto first = static_cast<std::uint32_t>(base);
        neighbours_[a].push_back(first + crease.b);
        neighbours_[b].push_back(first + crease.a);
    }

    /// Stores the patch's edges and vertex normals, and notes its corners where creases are.
    void visit(std::uint32_t patch) {
        const PatchCorners& corners = set_.corners[patch];
        const std::uint32_t count = is_quad(corners) ? 4 : 3;
        dvec3 p[4];
        for (std::uint32_t k = 0; k < count; ++k)
            p[k] = position(set_.control_vertices[corners[k]]);
        const dvec3 normal = count == 3 ? glm::cross(p[1] - p[0], p[2] - p[0]) : glm::cross(p[2] - p[0], p[3] - p[1]);
        const double length = glm::length(normal);
        const dvec3 unit = length > 0.0 ? normal / length : dvec3(0.0);
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t next = (k + 1) % count;
            const std::uint32_t previous = (k + count - 1) % count;
            const std::uint32_t at = number_[corners[k]];
            CornerTags& tags = set_.corner_tags[patch][k];
            std::ranges::copy(set_.control_vertices[corners[k]].normal, tags.normal);
            const auto crease = creases_.find(edge_key(at, number_[corners[next]]));
            tags.edge = crease == creases_.end() ? 0.0f : crease->second;
            if (!neighbours_.contains(at)) continue;
            const dvec3 a = p[next] - p[k];
            const dvec3 b = p[previous] - p[k];
            const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
            incidents_[at].push_back({patch, k, number_[corners[next]], number_[corners[previous]], unit * angle});
        }
    }

    void set_normals(std::uint32_t at, std::span<const Incident> incidents) {
        const Surroundings around(at, incidents, creases_);
        const auto vertex_normal = [&](std::size_t i) -> const float(&)[3] {
            return set_.control_vertices[set_.corners[incidents[i].patch][incidents[i].corner]].normal;
        };
        for (std::size_t i = 0; i < incidents.size(); ++i) {
            CornerTags& tags = set_.corner_tags[incidents[i].patch][incidents[i].corner];
            store_unit(around.normal(i), vertex_normal(around.leader(i)), tags.normal);
        }
        float smooth[3];
        store_unit(around.smooth_normal(), vertex_normal(0), smooth);
        std::ranges::copy(smooth, normals_[at].begin());
    }

    void finish_vertex(std::size_t v) {
        const auto neighbours = neighbours_.find(number_[v]);
        const auto normal = normals_.find(number_[v]);
        if (neighbours == neighbours_.end() || normal == normals_.end()) return;
        VertexTags& tags = set_.vertex_tags[v];
        std::ranges::copy(normal->second, tags.normal);
        const bool is_corner = corners_.contains(number_[v]) && corners_.at(number_[v]) > 0.0f;
        if (neighbours->second.size() != 2 || is_corner) return;
        const float none[3]{};
        store_unit(position(set_.control_vertices[neighbours->second[1]]) -
                       position(set_.control_vertices[neighbours->second[0]]),
                   none, tags.crease);
    }

    PatchSet& set_;
    std::vector<std::uint32_t> number_;
    std::unordered_map<std::uint64_t, float> creases_;                          // by edge of positions
    std::unordered_map<std::uint32_t, float> corners_;                          // by position
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> neighbours_;  // other ends of creases, as vertices
    std::unordered_map<std::uint32_t, std::vector<Incident>> incidents_;
    std::unordered_map<std::uint32_t, std::array<float, 3>> normals_;
};

}  // namespace

float crease_share(float sharpness) {
    if (!(sharpness > 0.0f)) return 0.0f;
    if (sharpness >= 10.0f) return 1.0f;
    const float whole = std::floor(sharpness);
    // 2^-s between whole s on the line between its neighbours: exact steps, the same on every machine.
    return flush_tag(1.0f - std::ldexp(1.0f - 0.5f * (sharpness - whole), -static_cast<int>(whole)));
}

void add_surface_tags(const scene::Scene& scene, PatchSet& set) {
    const bool subdivision = std::ranges::any_of(
        scene.meshes, [](const scene::Mesh& mesh) { return !mesh.tags.creases.empty() || !mesh.tags.corners.empty(); });
    const bool scalars = std::ranges::any_of(
        scene.meshes, [](const scene::Mesh& mesh) { return !mesh.alphas.empty() || !mesh.stpn.empty(); });
    if (!subdivision && !scalars) return;
    set.vertex_tags.resize(set.control_vertices.size());
    std::size_t base = 0;
    for (const scene::Mesh& mesh : scene.meshes) {
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            VertexTags& tags = set.vertex_tags[base + v];
            if (!mesh.alphas.empty()) tags.alpha = flush_tag(mesh.alphas[v]);
            if (mesh.stpn.empty()) continue;
            tags.sharpness = flush_tag(mesh.stpn[v].x);
            tags.bias = flush_tag(mesh.stpn[v].y);
            tags.tension = flush_tag(mesh.stpn[v].z);
        }
        base += mesh.positions.size();
    }
    if (subdivision) CreaseBuilder(scene, set).build();
}

}  // namespace tessera::patches
