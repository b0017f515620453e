// The ring table against the closed form of the tessellator, for every number of rings.
#include "tessellate/ring_table.hpp"

#include "tessellator/factors.h"
#include "tessellator/ring_table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>

namespace tessera {
namespace {

kernels::TrianglePatch make_patch(float outer, float inside, std::uint32_t partitioning) {
    std::uint32_t raw[6];
    for (std::uint32_t i = 0; i < 6; ++i)
        raw[i] = std::bit_cast<std::uint32_t>(i < 3 ? outer + static_cast<float>(i) : inside);
    const kernels::PatchRecord r = kernels::make_patch_record(raw, partitioning, DOMAIN_TRIANGLE, 0);
    return kernels::make_triangle_patch(r.flags, r.factor[0], r.factor[1], r.factor[2], r.factor[3]);
}

template <typename Body>
void for_many_patches(Body&& body) {
    for (const std::uint32_t partitioning :
         {PARTITIONING_INTEGER, PARTITIONING_FRACTIONAL_ODD, PARTITIONING_FRACTIONAL_EVEN}) {
        for (float inside = 1.0f; inside <= 64.0f; inside += 0.375f) {
            SCOPED_TRACE(fmt::format("partitioning {} inside {}", partitioning, inside));
            body(make_patch(1.0f + inside * 0.7f, inside, partitioning));
        }
    }
}

TEST(RingTable, HasThePointsOfEveryPattern) {
    const std::span<const std::uint32_t> table = ring_table(false);
    for_many_patches([&](const kernels::TrianglePatch& p) {
        if (!kernels::triangle_has_rings(p)) return;
        const kernels::RingPlace place = kernels::ring_place(p);
        const std::uint32_t count = kernels::triangle_point_count(p);
        for (std::uint32_t i = 0; i < count; ++i) {
            const kernels::DomainPoint expected = kernels::triangle_point(p, i);
            const kernels::DomainPoint found =
                i < p.outer_points
                    ? kernels::outer_point(p, i)
                    : kernels::inner_point(p.inside, table[place.points + i - p.outer_points] - place.shift);
            ASSERT_EQ(found.u, expected.u) << i;
            ASSERT_EQ(found.v, expected.v) << i;
        }
    });
}

TEST(RingTable, HasTheTrianglesOfEveryPattern) {
    const std::span<const std::uint32_t> table = ring_table(false);
    const std::span<const std::uint32_t> flipped = ring_table(true);
    for_many_patches([&](const kernels::TrianglePatch& p) {
        if (!kernels::triangle_has_rings(p)) return;
        const kernels::RingPlace place = kernels::ring_place(p);
        const std::uint32_t first = kernels::triangle_outer_count(p);
        const std::uint32_t count = kernels::triangle_triangle_count(p);
        for (std::uint32_t t = first; t < count; ++t) {
            const kernels::Triangle expected =
                kernels::triangle_inner_triangle(p, kernels::triangle_row_window(p, t), t);
            const std::uint32_t at = place.triangles + 3 * (t - first);
            ASSERT_EQ(table[at] + place.base, expected.a) << t;
            ASSERT_EQ(table[at + 1] + place.base, expected.b) << t;
            ASSERT_EQ(table[at + 2] + place.base, expected.c) << t;
            ASSERT_EQ(flipped[at + 1] + place.base, expected.c) << t;
            ASSERT_EQ(flipped[at + 2] + place.base, expected.b) << t;
        }
    });
}

TEST(RingTable, HasTheStepsOfEveryOutermostRow) {
    const std::span<const std::uint32_t> table = ring_table(false);
    for_many_patches([&](const kernels::TrianglePatch& p) {
        if (!kernels::triangle_has_rings(p)) return;
        for (std::uint32_t t = 0; t < kernels::triangle_outer_count(p); ++t) {
            const kernels::Triangle expected = kernels::triangle_outer_triangle(p, t);
            const kernels::OuterPlace place = kernels::triangle_outer_place(p, t);
            const std::uint32_t step = kernels::ring_step(p, place);
            const kernels::Triangle found = kernels::triangle_outer_stepped(
                p, place, kernels::ring_step_of(table[kernels::ring_step_word(step)], step));
            ASSERT_EQ(found.a, expected.a) << t;
            ASSERT_EQ(found.b, expected.b) << t;
            ASSERT_EQ(found.c, expected.c) << t;
        }
    });
}

}  // namespace
}  // namespace tessera
