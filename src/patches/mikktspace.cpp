#include "patches/mikktspace.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace tessera::patches {
namespace {

using glm::vec2;
using glm::vec3;

constexpr std::uint32_t none = 0xffffffffu;
constexpr std::size_t most_compared = 64;  // faces of a group that are compared with each other

/// What decisions hang on is computed in single precision and in the order of the formulas, as bakers of normal maps
/// do.
bool is_something(float x) {
    return std::isfinite(x) && std::fabs(x) > std::numeric_limits<float>::min();
}

bool is_something(const vec3& v) {
    return is_something(v.x) || is_something(v.y) || is_something(v.z);
}

float dot(const vec3& a, const vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

vec3 unit_or_same(const vec3& v) {
    return is_something(v) ? v * (1.0f / std::sqrt(dot(v, v))) : v;
}

/// A direction in the plane of a unit normal.
vec3 in_plane(const vec3& v, const vec3& normal) {
    return unit_or_same(v - dot(normal, v) * normal);
}

/// A corner of a triangle: all that tells corners apart.
struct Point {
    vec3 position{};
    vec3 normal{};
    vec2 uv{};

    bool operator==(const Point&) const = default;
};

struct PointHash {
    std::size_t operator()(const Point& p) const {
        std::uint64_t hash = 0;
        for (const float x :
             {p.position.x, p.position.y, p.position.z, p.normal.x, p.normal.y, p.normal.z, p.uv.x, p.uv.y}) {
            std::uint32_t bits = 0;
            std::memcpy(&bits, &x, sizeof bits);
            hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 29;
        }
        return hash;
    }
};

struct Triangle {
    std::uint32_t face = 0;
    std::array<std::uint8_t, 3> corner{};      // of the face
    std::array<std::uint32_t, 3> point{};      // numbers of Points
    std::array<std::uint32_t, 3> neighbour{};  // across the edge from corner i to the next, or none
    std::array<std::uint32_t, 3> group{};      // of corner i, or none
    vec3 tangent{}, bitangent{};               // along the coordinates, unit
    float texture_area = 0.0f;                 // doubled, without sign
    bool flat_texture = true;                  // has no directions of its own, goes with any group
    bool preserving = false;                   // the texture is not mirrored
};

class Tangents {
public:
    Tangents(std::span<const Vertex> vertices, std::span<const PatchCorners> faces, const glm::mat3& placement)
        : vertices_(vertices), faces_(faces), placement_(placement), out_(faces.size()), count_(faces.size()) {}

    std::vector<std::array<glm::vec4, 4>> compute() {
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            for (std::size_t c = 0; c < corner_count(f); ++c)
                out_[f][c] = {1.0f, 0.0f, 0.0f, 1.0f};
        }
        make_triangles();
        for (Triangle& t : triangles_)
            set_directions(t);
        orient_quads();
        find_neighbours();
        make_groups();
        copy_to_collapsed();
        return std::move(out_);
    }

private:
    std::size_t corner_count(std::size_t face) const { return is_quad(faces_[face]) ? 4 : 3; }

    Point point_of(std::size_t face, std::size_t corner) const {
        const Vertex& v = vertices_[faces_[face][corner]];
        const vec3 uv = placement_ * vec3(v.uv[0], v.uv[1], 1.0f);
        // Without negative zeros, equal numbers have equal bits.
        return {vec3(v.position[0], v.position[1], v.position[2]) + 0.0f,
                vec3(v.normal[0], v.normal[1], v.normal[2]) + 0.0f, vec2(uv) + 0.0f};
    }

    std::uint32_t number_of(const Point& point) {
        const auto [found, is_new] = numbers_.emplace(point, static_cast<std::uint32_t>(points_.size()));
        if (is_new) points_.push_back(point);
        return found->second;
    }

    /// Cuts quads along the diagonal that is shorter in the texture, or else in space. Triangles with two corners in
    /// one place are set aside.
    void make_triangles() {
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            std::array<std::uint32_t, 4> p{};
            for (std::size_t c = 0; c < corner_count(f); ++c)
                p[c] = number_of(point_of(f, c));
            if (corner_count(f) == 3) {
                add_triangle(f, {0, 1, 2}, p);
            } else if (is_cut_from_0_to_2(p)) {
                add_triangle(f, {0, 1, 2}, p);
                add_triangle(f, {0, 2, 3}, p);
            } else {
                add_triangle(f, {0, 1, 3}, p);
                add_triangle(f, {1, 2, 3}, p);
            }
        }
    }

    bool is_cut_from_0_to_2(const std::array<std::uint32_t, 4>& p) const {
        const auto squared_uv = [&](std::size_t a, std::size_t b) {
            const vec2 d = points_[p[b]].uv - points_[p[a]].uv;
            return d.x * d.x + d.y * d.y;
        };
        if (squared_uv(0, 2) < squared_uv(1, 3)) return true;
        if (squared_uv(1, 3) < squared_uv(0, 2)) return false;
        const auto squared = [&](std::size_t a, std::size_t b) {
            const vec3 d = points_[p[b]].position - points_[p[a]].position;
            return dot(d, d);
        };
        return !(squared(1, 3) < squared(0, 2));
    }

    void add_triangle(std::size_t face, std::array<std::uint8_t, 3> corners, const std::array<std::uint32_t, 4>& p) {
        Triangle t;
        t.face = static_cast<std::uint32_t>(face);
        t.corner = corners;
        t.point = {p[corners[0]], p[corners[1]], p[corners[2]]};
        t.neighbour = t.group = {none, none, none};
        const vec3 &a = points_[t.point[0]].position, &b = points_[t.point[1]].position,
                   &c = points_[t.point[2]].position;
        (a == b || b == c || c == a ? collapsed_ : triangles_).push_back(t);
    }

    void set_directions(Triangle& t) const {
        const Point &a = points_[t.point[0]], &b = points_[t.point[1]], &c = points_[t.point[2]];
        const vec2 st1 = b.uv - a.uv;
        const vec2 st2 = c.uv - a.uv;
        const vec3 d1 = b.position - a.position;
        const vec3 d2 = c.position - a.position;
        const float area = st1.x * st2.y - st1.y * st2.x;
        t.preserving = area > 0.0f;
        t.texture_area = std::fabs(area);
        if (!is_something(area)) return;
        const float sign = t.preserving ? 1.0f : -1.0f;
        const vec3 along_s = st2.y * d1 - st1.y * d2;
        const vec3 along_t = -st2.x * d1 + st1.x * d2;
        const float length_s = std::sqrt(dot(along_s, along_s));
        const float length_t = std::sqrt(dot(along_t, along_t));
        if (is_something(length_s)) t.tangent = (sign / length_s) * along_s;
        if (is_something(length_t)) t.bitangent = (sign / length_t) * along_t;
        t.flat_texture = !is_something(length_s / t.texture_area) || !is_something(length_t / t.texture_area);
    }

    /// Both triangles of a quad have one orientation: that of the larger where they disagree.
    void orient_quads() {
        for (std::size_t i = 0; i + 1 < triangles_.size(); ++i) {
            Triangle &a = triangles_[i], &b = triangles_[i + 1];
            if (a.face != b.face) continue;
            const bool by_first = b.flat_texture || !(a.texture_area < b.texture_area);
            (by_first ? b : a).preserving = (by_first ? a : b).preserving;
            ++i;
        }
    }

    struct Edge {
        std::uint32_t low = 0, high = 0;  // points
        std::uint32_t triangle = 0;
        std::uint8_t side = 0;  // edge of the triangle
        bool rising = false;    // runs from low to high
        auto operator<=>(const Edge&) const = default;
    };

    /// Pairs edges that run in opposite directions, in the order of triangles where there are more than two.
    void find_neighbours() {
        std::vector<Edge> edges;
        edges.reserve(3 * triangles_.size());
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            for (std::uint8_t side = 0; side < 3; ++side) {
                const std::uint32_t from = triangles_[i].point[side];
                const std::uint32_t to = triangles_[i].point[(side + 1u) % 3u];
                edges.push_back(
                    {std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(i), side, from < to});
            }
        }
        std::ranges::sort(edges);
        std::vector<const Edge*>
            waiting;  // of the same two points, all in one direction; those before `next` have left
        std::size_t next = 0;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const Edge& edge = edges[i];
            if (i == 0 || edges[i - 1].low != edge.low || edges[i - 1].high != edge.high) {
                waiting.clear();
                next = 0;
            }
            if (next == waiting.size() || waiting[next]->rising == edge.rising) {
                waiting.push_back(&edge);
                continue;
            }
            const Edge& other = *waiting[next++];
            triangles_[edge.triangle].neighbour[edge.side] = other.triangle;
            triangles_[other.triangle].neighbour[other.side] = edge.triangle;
        }
    }

    std::size_t corner_at(const Triangle& t, std::uint32_t point) const {
        return t.point[0] == point ? 0 : t.point[1] == point ? 1 : 2;
    }

    void make_groups() {
        std::uint32_t group = 0;
        std::vector<std::uint32_t> members;
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                if (triangles_[i].flat_texture || triangles_[i].group[corner] != none) continue;
                collect(i, corner, group++, members);
                std::ranges::sort(members);
                set_tangents(triangles_[i].point[corner], triangles_[i].preserving, members);
            }
        }
    }

    /// The triangles around a corner, from edge to edge, that have its orientation. One whose texture is flat takes
    /// the orientation of the first group that it comes to.
    void collect(std::uint32_t first, std::size_t corner, std::uint32_t group, std::vector<std::uint32_t>& members) {
        const std::uint32_t point = triangles_[first].point[corner];
        const bool preserving = triangles_[first].preserving;
        members.clear();
        std::vector<std::uint32_t> to_visit{first};
        while (!to_visit.empty()) {
            const std::uint32_t number = to_visit.back();
            to_visit.pop_back();
            Triangle& t = triangles_[number];
            const std::size_t at = corner_at(t, point);
            if (t.group[at] != none) continue;
            if (t.flat_texture && t.group == std::array{none, none, none}) t.preserving = preserving;
            if (t.preserving != preserving) continue;
            t.group[at] = group;
            members.push_back(number);
            const std::uint32_t left = t.neighbour[at];
            const std::uint32_t right = t.neighbour[(at + 2) % 3];
            if (right != none) to_visit.push_back(right);
            if (left != none) to_visit.push_back(left);
        }
    }

    /// Whether two triangles of a group share a tangent: all do but opposite ones.
    bool go_together(const Triangle& a, const Triangle& b, const vec3& normal) const {
        if (a.flat_texture || b.flat_texture || a.face == b.face) return true;
        return dot(in_plane(a.tangent, normal), in_plane(b.tangent, normal)) > -1.0f &&
               dot(in_plane(a.bitangent, normal), in_plane(b.bitangent, normal)) > -1.0f;
    }

    void set_tangents(std::uint32_t point, bool preserving, const std::vector<std::uint32_t>& members) {
        const vec3& normal = points_[point].normal;
        const vec3 all = mean_tangent(point, members);
        std::vector<std::uint32_t> together;
        for (const std::uint32_t member : members) {
            vec3 tangent = all;
            if (members.size() <= most_compared) {
                together.clear();
                std::ranges::copy_if(members, std::back_inserter(together), [&](std::uint32_t other) {
                    return go_together(triangles_[member], triangles_[other], normal);
                });
                if (together.size() != members.size()) tangent = mean_tangent(point, together);
            }
            store(triangles_[member], corner_at(triangles_[member], point), tangent, preserving);
        }
    }

    vec3 mean_tangent(std::uint32_t point, const std::vector<std::uint32_t>& members) const {
        const Point& at = points_[point];
        vec3 sum(0.0f);
        for (const std::uint32_t member : members) {
            const Triangle& t = triangles_[member];
            if (t.flat_texture) continue;
            const std::size_t corner = corner_at(t, point);
            const auto edge_to = [&](std::size_t other) {
                return in_plane(points_[t.point[other % 3]].position - at.position, at.normal);
            };
            const float cosine = std::clamp(dot(edge_to(corner + 2), edge_to(corner + 1)), -1.0f, 1.0f);
            sum += std::acos(cosine) * in_plane(t.tangent, at.normal);
        }
        return unit_or_same(sum);
    }

    /// The corner of a quad that two triangles share gets the mean of theirs.
    void store(const Triangle& t, std::size_t corner, const vec3& tangent, bool preserving) {
        glm::vec4& to = out_[t.face][t.corner[corner]];
        std::uint8_t& count = count_[t.face][t.corner[corner]];
        const vec3 before(to);
        const vec3 value = count == 0 || before == tangent ? tangent : unit_or_same(before + tangent);
        to = {value, preserving ? -1.0f : 1.0f};
        ++count;
    }

    /// Corners of collapsed triangles take the tangent of the first sound corner that is the same point, and the fourth
    /// corner of a quad that is half collapsed that of the corner in the same place.
    void copy_to_collapsed() {
        std::unordered_map<std::uint32_t, std::pair<std::uint32_t, std::uint8_t>> first;
        for (const Triangle& t : triangles_) {
            for (std::size_t c = 0; c < 3 && !collapsed_.empty(); ++c)
                first.emplace(t.point[c], std::pair{t.face, t.corner[c]});
        }
        std::vector<bool> is_sound(faces_.size());
        for (const Triangle& t : triangles_)
            is_sound[t.face] = true;
        for (const Triangle& t : collapsed_) {
            for (std::size_t c = 0; c < 3; ++c) {
                if (is_sound[t.face]) {
                    copy_within_quad(t, c);
                } else if (const auto found = first.find(t.point[c]); found != first.end()) {
                    out_[t.face][t.corner[c]] = out_[found->second.first][found->second.second];
                }
            }
        }
    }

    /// `t` is the collapsed half of a quad.
    void copy_within_quad(const Triangle& t, std::size_t corner) {
        const std::size_t missing = t.corner[corner];
        if (count_[t.face][missing] > 0) return;
        for (std::size_t other = 0; other < 4; ++other) {
            const bool same_place = place_of(t.face, other) == place_of(t.face, missing);
            if (count_[t.face][other] == 0 || !same_place) continue;
            out_[t.face][missing] = out_[t.face][other];
            return;
        }
    }

    vec3 place_of(std::size_t face, std::size_t corner) const { return point_of(face, corner).position; }

    std::span<const Vertex> vertices_;
    std::span<const PatchCorners> faces_;
    glm::mat3 placement_;
    std::vector<Point> points_;
    std::unordered_map<Point, std::uint32_t, PointHash> numbers_;
    std::vector<Triangle> triangles_, collapsed_;
    std::vector<std::array<glm::vec4, 4>> out_;
    std::vector<std::array<std::uint8_t, 4>> count_;  // tangents stored per corner
};

}  // namespace

std::vector<std::array<glm::vec4, 4>> corner_tangents(std::span<const Vertex> vertices,
                                                      std::span<const PatchCorners> faces, const glm::mat3& placement) {
    return Tangents(vertices, faces, placement).compute();
}

}  // namespace tessera::patches
