#include "tessellate/quad_faces.hpp"

#include "tessellator/quad.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <vector>

namespace tessera {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

/// A point's column and row in the grid of a quad's pattern.
struct Place {
    std::uint32_t u = none, v = none;
};

/// The grid of a pattern: the places of its points, in order, those that are in no column and row left out.
struct Grid {
    std::uint32_t columns = 0, rows = 0;
    std::vector<Place> places;
};

/// Points of a rectangular ring from (u0, v1) down, to the right, up and back.
void add_ring(std::vector<Place>& places, std::uint32_t u0, std::uint32_t u1, std::uint32_t v0, std::uint32_t v1) {
    for (std::uint32_t v = v1; v > v0; --v)
        places.push_back({u0, v});
    for (std::uint32_t u = u0; u < u1; ++u)
        places.push_back({u, v0});
    for (std::uint32_t v = v0; v < v1; ++v)
        places.push_back({u1, v});
    for (std::uint32_t u = u1; u > u0; --u)
        places.push_back({u, v1});
}

/// The outer ring: where an edge has as many points as the axis beside it they are in its columns or rows, else only
/// its corners are.
void add_outer_ring(std::vector<Place>& places, const kernels::QuadPatch& p) {
    const std::uint32_t right = p.inside_u.points - 1;
    const std::uint32_t top = p.inside_v.points - 1;
    const std::array edges{p.edge0.points, p.edge1.points, p.edge2.points, p.edge3.points};
    const std::array corners{Place{0, top}, Place{0, 0}, Place{right, 0}, Place{right, top}};
    for (std::size_t side = 0; side < 4; ++side) {
        const Place from = corners[side];
        const Place to = corners[(side + 1) % 4];
        const std::uint32_t axis = side % 2 == 0 ? top : right;
        for (std::uint32_t k = 0; k + 1 < edges[side]; ++k) {
            const bool known = k == 0 || edges[side] == axis + 1;
            const auto along = [&](std::uint32_t a, std::uint32_t b) { return a < b ? a + k : (a > b ? a - k : a); };
            places.push_back(known ? Place{along(from.u, to.u), along(from.v, to.v)} : Place{});
        }
    }
}

Grid make_grid(const kernels::QuadPatch& p) {
    Grid grid;
    if ((p.flags & RECORD_SINGLE) != 0u) {
        return {2, 2, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    }
    if ((p.flags & RECORD_UNIFORM) != 0u) {
        grid.columns = grid.rows = p.level + 1;
        for (std::uint32_t v = 0; v <= p.level; ++v)
            for (std::uint32_t u = 0; u <= p.level; ++u)
                grid.places.push_back({u, v});
        return grid;
    }
    grid.columns = p.inside_u.points;
    grid.rows = p.inside_v.points;
    add_outer_ring(grid.places, p);
    for (std::uint32_t r = 1; r <= p.rings; ++r)
        add_ring(grid.places, r, grid.columns - 1 - r, r, grid.rows - 1 - r);
    if (p.final_row != 0) {
        const std::uint32_t r = p.rings + 1;
        if (grid.columns > grid.rows) {
            for (std::uint32_t u = r; u <= grid.columns - 1 - r; ++u)
                grid.places.push_back({u, r});
        } else {
            for (std::uint32_t v = grid.rows - r; v-- > r;)
                grid.places.push_back({r, v});
        }
    }
    assert(grid.places.size() == kernels::quad_point_count(p));
    return grid;
}

using Corners = std::array<std::uint32_t, 3>;  // local to the patch

/// The cell that a triangle is half of, or nothing.
std::optional<std::uint32_t> cell_of(const Grid& grid, const Corners& triangle) {
    Place low{none, none};
    Place high{0, 0};
    for (const std::uint32_t corner : triangle) {
        const Place& place = grid.places[corner];
        if (place.u == none) return std::nullopt;
        low = {std::min(low.u, place.u), std::min(low.v, place.v)};
        high = {std::max(high.u, place.u), std::max(high.v, place.v)};
    }
    if (high.u - low.u != 1 || high.v - low.v != 1) return std::nullopt;
    return low.v * grid.columns + low.u;
}

Corners corners_at(std::span<const std::uint32_t> indices, std::size_t triangle, std::uint32_t first_vertex) {
    return {indices[3 * triangle] - first_vertex, indices[3 * triangle + 1] - first_vertex,
            indices[3 * triangle + 2] - first_vertex};
}

/// For each triangle its other half, or none.
std::vector<std::uint32_t> pair_halves(const Grid& grid, std::span<const std::uint32_t> indices,
                                       std::uint32_t first_vertex) {
    std::vector<std::uint32_t> partner(indices.size() / 3, none);
    std::vector<std::uint32_t> first(std::size_t{grid.columns} * grid.rows, none);
    for (std::uint32_t t = 0; t < partner.size(); ++t) {
        const auto cell = cell_of(grid, corners_at(indices, t, first_vertex));
        if (!cell) continue;
        if (first[*cell] == none) {
            first[*cell] = t;
        } else {
            partner[first[*cell]] = t;
            partner[t] = first[*cell];
        }
    }
    return partner;
}

/// The corners of a quad around its two halves, diagonal from corner 0 to corner 2; nothing where they share no edge.
std::optional<std::array<std::uint32_t, 4>> join(const Corners& one, const Corners& two) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (one[(i + 1) % 3] == two[(k + 2) % 3] && one[(i + 2) % 3] == two[(k + 1) % 3]) {
                return std::array{one[(i + 1) % 3], two[k], one[(i + 2) % 3], one[i]};
            }
        }
    }
    return std::nullopt;
}

/// Faces one after another, each beginning with another corner than the one before.
class FaceList {
public:
    FaceList(std::uint32_t first_vertex, std::vector<std::uint32_t>& indices, std::span<std::uint8_t> quads)
        : first_vertex_(first_vertex), indices_(indices), quads_(quads) {}

    void add(Corners c) {
        if (c[0] == last_) std::rotate(c.begin(), c.begin() + 1, c.end());
        put(c, 0);
    }
    void add(std::array<std::uint32_t, 4> c) {
        if (c[0] == last_) std::rotate(c.begin(), c.begin() + 2, c.end());  // the diagonal stays
        put({c[0], c[1], c[2]}, 1);
        put({c[0], c[2], c[3]}, 0);
    }

private:
    void put(const Corners& c, std::uint8_t is_quad) {
        quads_[indices_.size() / 3] = is_quad;
        for (const std::uint32_t corner : c)
            indices_.push_back(first_vertex_ + corner);
        last_ = c[0];
    }

    std::uint32_t first_vertex_;
    std::vector<std::uint32_t>& indices_;
    std::span<std::uint8_t> quads_;
    std::uint32_t last_ = none;
};

}  // namespace

void mark_quads(RecordView record, std::uint32_t first_vertex, std::span<std::uint32_t> indices,
                std::span<std::uint8_t> quads) {
    assert(indices.size() == 3 * quads.size());
    if (indices.empty()) return;
    std::vector<std::uint32_t> partner(quads.size(), none);
    if ((record[0] & RECORD_DOMAIN_MASK) == DOMAIN_QUAD) {
        const kernels::QuadPatch patch =
            kernels::make_quad_patch(record[0], record[1], record[2], record[3], record[4], record[5], record[6]);
        partner = pair_halves(make_grid(patch), indices, first_vertex);
    }
    std::vector<std::uint32_t> ordered;
    ordered.reserve(indices.size());
    FaceList list(first_vertex, ordered, quads);
    for (std::uint32_t t = 0; t < partner.size(); ++t) {
        const Corners own = corners_at(indices, t, first_vertex);
        if (partner[t] == none) {
            list.add(own);
        } else if (partner[t] > t) {
            const Corners other = corners_at(indices, partner[t], first_vertex);
            if (const auto quad = join(own, other)) {
                list.add(*quad);
            } else {
                list.add(own);
                list.add(other);
            }
        }
    }
    std::ranges::copy(ordered, indices.begin());
}

}  // namespace tessera
