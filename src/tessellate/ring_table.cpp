#include "tessellate/ring_table.hpp"

#include "tessellator/ring_table.h"

#include <utility>
#include <vector>

namespace tessera {
namespace {

/// A patch whose inside factor makes 64 or 65 points; its outer factors do not matter here.
kernels::TrianglePatch largest_patch(std::uint32_t points) {
    const std::uint32_t factor = (points - 1) << 16;
    return kernels::make_triangle_patch(points == 64 ? 15u << RECORD_ODD_SHIFT : 0u, factor, factor, factor, factor);
}

void put_points(std::uint32_t* words, const kernels::TrianglePatch& p) {
    const kernels::Edge& edge = p.inside;
    const auto put = [&](std::uint32_t ring, std::uint32_t side, std::uint32_t at) {
        const bool far = at >= edge.half_points;
        const std::uint32_t nearer = far ? edge.points - 1 - at : at;
        *words++ = ring | nearer << 8 | (far ? RING_POINT_FAR : 0u) | side * RING_POINT_SIDE1;
    };
    for (std::uint32_t ring = 1; ring <= p.rings; ++ring) {
        const std::uint32_t last = edge.points - 1 - ring;
        for (std::uint32_t side = 0; side < 3; ++side) {
            for (std::uint32_t k = 0; k < last - ring; ++k)
                put(ring, side, side == 1 ? ring + k : last - k);
        }
    }
    if (edge.odd == 0) put(edge.half_points, 0, edge.half_points);  // the centre
}

void put_triangles(std::uint32_t* words, const kernels::TrianglePatch& p, bool flip) {
    const std::uint32_t first = kernels::triangle_outer_count(p);
    for (std::uint32_t t = first; t < kernels::triangle_triangle_count(p); ++t) {
        const kernels::Triangle corners = kernels::triangle_inner_triangle(p, kernels::triangle_row_window(p, t), t);
        *words++ = corners.a - p.outer_points;
        *words++ = (flip ? corners.c : corners.b) - p.outer_points;
        *words++ = (flip ? corners.b : corners.c) - p.outer_points;
    }
}

void put_steps(std::uint32_t* words) {
    for (std::uint32_t outer = 0; outer <= 32; ++outer) {
        for (std::uint32_t inner = 1; inner <= 32; ++inner) {
            for (std::uint32_t t = 0; t < outer + inner - 1; ++t) {
                const std::uint32_t at = kernels::ring_steps_before(outer, inner) + t;
                words[at / 4] |= kernels::transition_step(t, outer, inner) << 8 * (at % 4);
            }
        }
    }
}

std::vector<std::uint32_t> make_words(bool flip) {
    std::vector<std::uint32_t> words(RING_TABLE_WORDS);
    for (const auto& [points, points_at, triangles_at] :
         {std::tuple{64u, RING_POINTS_AT_64, RING_TRIANGLES_AT_64}, {65u, RING_POINTS_AT_65, RING_TRIANGLES_AT_65}}) {
        const kernels::TrianglePatch patch = largest_patch(points);
        put_points(words.data() + points_at, patch);
        put_triangles(words.data() + triangles_at, patch, flip);
    }
    put_steps(words.data() + RING_STEPS_AT);
    return words;
}

}  // namespace

std::span<const std::uint32_t> ring_table(bool flip) {
    static const std::vector<std::uint32_t> tables[] = {make_words(false), make_words(true)};
    return tables[flip ? 1 : 0];
}

gpu::Buffer make_ring_table(gpu::Device& device, bool flip) {
    return gpu::create_filled_buffer(device, "ring table", std::as_bytes(ring_table(flip)));
}

std::uint64_t ring_table_bytes() {
    return std::uint64_t{RING_TABLE_WORDS} * 4;
}

}  // namespace tessera
